# Reads results.csv; writes the tables of docs/render/benchmarks.md: a row for each way to draw each scene.
BEGIN {
  FS = ","
  kernels = split("render depth visible", kernel, " ")
  title["render"] = "Colour and depth"
  title["depth"] = "Depth alone"
  title["visible"] = "Scenes of which a share is seen"
}
NR == 1 { next }
{
  key = $1 SUBSEP $2
  if (!(key in seen)) { seen[key] = 1; cases[$1, ++count[$1]] = $2 }
  line[key, ++rows[key]] = $0
  if ($3 == "llvmpipe") peer[key] = $5
}
function two(v) { return v == "" ? "" : sprintf("%.2f", v) }
END {
  for (i = 1; i <= kernels; ++i) {
    k = kernel[i]
    if (!(k in count)) continue
    printf "\n### %s\n\n", title[k]
    print "| scene | | ms | of llvmpipe's time | of the limit's | greatest error | mean error | wrong pixels |"
    print "|---|---|---|---|---|---|---|---|"
    for (j = 1; j <= count[k]; ++j) {
      key = k SUBSEP cases[k, j]
      for (r = 1; r <= rows[key]; ++r) {
        split(line[key, r], f, ",")
        ours = f[3] ~ /^irg/ && (key in peer)
        printf "| %s | %s | %.3g | %s | %s | %s | %s | %s |\n", r == 1 ? cases[k, j] : "", f[3], f[5] / 1e6,
          ours ? two(f[5] / peer[key]) : "", f[8] == "" ? "" : two(1 / f[8]), f[9], f[10], f[12]
      }
    }
  }
}
