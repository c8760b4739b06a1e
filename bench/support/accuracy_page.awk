# Reads accuracy.csv; writes a section for each kernel: its picture, and a table of all its distributions.
function figure(v) { return v == 0 ? "0" : v >= 1e5 || v < 1e-3 ? sprintf("%.1e", v) : sprintf("%.3g", v) }
BEGIN { FS = "," }
FNR == 1 { next }
$1 != kernel {
  kernel = $1
  file = kernel
  gsub(/ /, "-", file)
  printf "\n## %s\n\n![Run time against error of %s](accuracy/%s.svg)\n\n", kernel, kernel, file
  printf "| distribution | implementation | ns | greatest error, %s | mean error | exact | failed |\n", $8
  print "|---|---|---:|---:|---:|---:|---:|"
}
{
  own = $3 ~ /^irg/ ? "**" : ""
  printf "| %s | %s%s%s | %s | %s | %s | %s %% | %s %% |\n", $2 == last ? "" : $2, own, $3, own, figure($5), figure($9), figure($10), figure($11), figure($12)
  last = $2
}
