// SPDX-License-Identifier: MIT
#include "hidden/hidden_lines_peer.hpp"

#if defined(IRG_HAVE_OCCT)
#include <map>
#include <utility>

#include <BRepBuilderAPI_Transform.hxx>
#include <BRepMesh_IncrementalMesh.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRep_Tool.hxx>
#include <HLRAlgo_Projector.hxx>
#include <HLRBRep_PolyAlgo.hxx>
#include <HLRBRep_PolyHLRToShape.hxx>
#include <Poly_Triangulation.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <gp_Ax2.hxx>

#include <irg/mesh/merge_positions.hpp>

namespace bench {
namespace {

struct scene_of_bodies {
  std::vector<TopoDS_Shape> shapes;
  std::vector<irg::mesh<double>> meshes;
};
std::map<int, scene_of_bodies>& scenes() {
  static std::map<int, scene_of_bodies> all;
  return all;
}

TopoDS_Shape shape_of(int i) {
  switch (i % 4) {
    case 0: return BRepPrimAPI_MakeSphere(0.9).Shape();
    case 1: return BRepPrimAPI_MakeTorus(0.7, 0.3).Shape();
    case 2: return BRepPrimAPI_MakeCylinder(0.6, 1.4).Shape();
    default: return BRepPrimAPI_MakeBox(1.1, 1.1, 1.1).Shape();
  }
}

irg::mesh<double> to_mesh(const TopoDS_Shape& shape) {
  irg::mesh<double> m;
  for (TopExp_Explorer e(shape, TopAbs_FACE); e.More(); e.Next()) {
    TopLoc_Location place;
    const TopoDS_Face face = TopoDS::Face(e.Current());
    const Handle(Poly_Triangulation) cut = BRep_Tool::Triangulation(face, place);
    if (cut.IsNull()) continue;
    const auto base = static_cast<std::uint32_t>(m.positions.size());
    for (int k = 1; k <= cut->NbNodes(); ++k) {
      const gp_Pnt p = cut->Node(k).Transformed(place.Transformation());
      m.positions.push_back({p.X(), p.Y(), p.Z()});
    }
    for (int k = 1; k <= cut->NbTriangles(); ++k) {
      int v[3];
      cut->Triangle(k).Get(v[0], v[1], v[2]);
      if (face.Orientation() == TopAbs_REVERSED) std::swap(v[1], v[2]);
      for (const int i : v) m.corners.push_back({base + static_cast<std::uint32_t>(i - 1)});
      m.face_starts.push_back(static_cast<std::uint32_t>(m.corners.size()));
    }
  }
  return irg::with_merged_positions(std::move(m));
}

}  // namespace

bool has_occt() { return true; }

const std::vector<irg::mesh<double>>& occt_bodies(int side, double deflection) {
  scene_of_bodies& s = scenes()[side];
  for (int i = 0; i < side * side && static_cast<int>(s.shapes.size()) < side * side; ++i) {
    gp_Trsf tilt, turn, move;
    tilt.SetRotation(gp_Ax1(gp_Pnt(0, 0, 0), gp_Dir(1, 0, 0)), 0.3 * i);
    turn.SetRotation(gp_Ax1(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1)), 0.7 * i);
    move.SetTranslation(gp_Vec(1.5 * (i % side - 0.5 * (side - 1)), 0, 1.5 * (i / side - 0.5 * (side - 1))));
    const TopoDS_Shape shape = BRepBuilderAPI_Transform(shape_of(i), move * tilt * turn, true).Shape();
    BRepMesh_IncrementalMesh(shape, deflection, false, 0.5, false);
    s.meshes.push_back(to_mesh(shape));
    s.shapes.push_back(shape);
  }
  return s.meshes;
}

std::int64_t occt_hidden_lines(int side) {
  const Handle(HLRBRep_PolyAlgo) algorithm = new HLRBRep_PolyAlgo();
  for (const TopoDS_Shape& shape : scenes()[side].shapes) algorithm->Load(shape);
  algorithm->Projector(HLRAlgo_Projector(gp_Ax2(gp_Pnt(0, 0, 0), gp_Dir(1, 0.7, 0.9))));
  algorithm->Update();
  HLRBRep_PolyHLRToShape shown;
  shown.Update(algorithm);
  std::int64_t n = 0;
  for (const TopoDS_Shape& edges : {shown.VCompound(), shown.OutLineVCompound()})
    for (TopExp_Explorer e(edges, TopAbs_EDGE); !edges.IsNull() && e.More(); e.Next()) ++n;
  return n;
}

}  // namespace bench

#else

namespace bench {

bool has_occt() { return false; }
const std::vector<irg::mesh<double>>& occt_bodies(int, double) {
  static const std::vector<irg::mesh<double>> none;
  return none;
}
std::int64_t occt_hidden_lines(int) { return 0; }

}  // namespace bench
#endif
