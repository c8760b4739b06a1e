// SPDX-License-Identifier: MIT
// What irg::compiled has of io, for float and double.
#include <irg/io/file.hpp>
#include <irg/io/image_file.hpp>
#include <irg/io/mesh_file.hpp>

namespace irg {

using bytes = std::vector<std::uint8_t>;

#define IRG_FOR_NUMBERS(T)                                                                      \
  template result<bytes, encode_error> encode_obj(const mesh<T>&);                              \
  template result<bytes, encode_error> encode_mesh(const mesh<T>&, mesh_format, mesh_encoding); \
  template result<mesh<T>> read_stl(std::string_view, stl_options);                             \
  template result<bytes, encode_error> encode_stl(const mesh<T>&, mesh_encoding);               \
  template result<mesh<T>> read_ply(std::string_view);                                          \
  template result<bytes, encode_error> encode_ply(const mesh<T>&, mesh_encoding);               \
  template result<mesh<T>> read_off(std::string_view);                                          \
  template result<bytes, encode_error> encode_off(const mesh<T>&);                              \
  template result<std::vector<stored_body<T>>> read_body_xml(std::string_view);                 \
  template result<bytes, encode_error> encode_body_xml(std::span<const stored_body<T>>);        \
  template result<std::vector<mtl_material<T>>> read_mtl(std::string_view);
IRG_FOR_NUMBERS(float)
IRG_FOR_NUMBERS(double)
#undef IRG_FOR_NUMBERS

template std::vector<std::string_view> material_libraries(std::string_view);
template mesh_format mesh_format_of(std::string_view) noexcept;

namespace detail {

#define IRG_FOR_NUMBERS(T)                                                   \
  template result<mesh<T>> read_mesh_as(std::string_view, mesh_format);      \
  template result<mesh<T>> read_obj_in_one_go(std::string_view, obj_unused); \
  template result<mesh<T>> read_obj_in_pieces(std::string_view, obj_unused, std::size_t, const executor_ref&);
IRG_FOR_NUMBERS(float)
IRG_FOR_NUMBERS(double)
#undef IRG_FOR_NUMBERS

template result<std::string> load_bytes(const std::string&);
template result<void> save_bytes(const std::string&, const std::string_view&);
template bytes compress_rows(const png_pixels<bytes>&, png_options::compression);
template bytes encode_png_pixels(const png_pixels<bytes>&, png_options::compression);
template result<image<rgba8>> read_png_file<bytes>(std::span<const std::uint8_t>, const png_read_options&);
template bytes encode_svg_runs(const image<rgba8>&);
template result<image<rgb8>> read_netpbm(std::span<const char>);
template result<image<rgb8>> read_netpbm(std::span<const std::uint8_t>);

}  // namespace detail
}  // namespace irg
