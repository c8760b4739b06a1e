# Reads accuracy.csv; writes a section for each kernel: its picture and a row for each implementation. Functions that
# irg is compared with libm alone in share one table.
function figure(v) { return v == 0 ? "0" : v >= 1e5 ? sprintf("%.0e", v) : v >= 1000 ? sprintf("%d", v) : v < 0.1 ? sprintf("%.1g", v) : sprintf("%.3g", v) }
function time(v) { return v >= 1e6 ? sprintf("%.3g ms", v / 1e6) : v >= 100 ? sprintf("%d", v + 0.5) : sprintf("%.3g", v) }
function file_of(kernel) { gsub(/ /, "-", kernel); return "accuracy/" kernel ".svg" }
function bold(name) { return name ~ /^irg/ ? "**" name "**" : name }
BEGIN { FS = "," }
FNR == 1 { for (i = 1; i <= NF; ++i) column[$i] = i; next }
{
  if (!($1 in unit)) { order[++kernels] = $1; unit[$1] = $column["error_unit"]; first[$1] = $2 }
  if (!(($1, $3) in seen)) { seen[$1, $3] = 1; who[$1, ++count[$1]] = $3; libm[$1] = libm[$1] $3 }
  if (!(($1, $2) in met)) { met[$1, $2] = 1; ++panels[$1] }
  ns = $column["ns_median"] + 0
  signs = unit[$1] == "wrong signs"
  error = signs ? $column["failed_percent"] + 0 : $column["max_error"] + 0
  failed = signs ? 0 : $column["failed_percent"] + 0
  if ($2 == first[$1]) { common_ns[$1, $3] = ns; common[$1, $3] = failed == 100 ? "failed" : figure(error) (signs && error > 0 ? " %" : "") }
  if (ns > most_ns[$1, $3]) { most_ns[$1, $3] = ns }
  if (error > most[$1, $3] || !(($1, $3) in most)) { most[$1, $3] = error; place[$1, $3] = $2 }
  if (failed > most_failed[$1, $3]) { most_failed[$1, $3] = failed; failing[$1, $3] = $2 }
  if ($2 ~ /\(float\)/) { if (error > float_error[$1, $3]) float_error[$1, $3] = error; if (!(($1, $3) in float_ns)) float_ns[$1, $3] = ns }
  else if (error > double_error[$1, $3]) double_error[$1, $3] = error
}
END {
  print "\n## Elementary functions\n"
  print "irg beside the C library (glibc): the time of a call with arguments from the first distribution, the greatest error of all, in ulp.\n"
  print "| function | irg, ns | libm, ns | irg, error | libm, error | float: irg, ns | libm, ns | irg, error | libm, error | picture |"
  print "|---|---:|---:|---:|---:|---:|---:|---:|---:|---|"
  for (i = 1; i <= kernels; ++i) {
    k = order[i]
    if (libm[k] != "irglibm") continue
    printf "| `%s` |", k
    for (j = 1; j <= 2; ++j) printf " %s |", time(common_ns[k, who[k, j]])
    for (j = 1; j <= 2; ++j) printf " %s |", figure(double_error[k, who[k, j]])
    for (j = 1; j <= 2; ++j) printf " %s |", time(float_ns[k, who[k, j]])
    for (j = 1; j <= 2; ++j) printf " %s |", figure(float_error[k, who[k, j]])
    printf " [%s](%s) |\n", panels[k] == 1 ? "1 distribution" : panels[k] " distributions", file_of(k)
  }
  for (i = 1; i <= kernels; ++i) {
    k = order[i]
    if (libm[k] == "irglibm") continue
    name = toupper(substr(k, 1, 1)) substr(k, 2)
    if (k ~ /^(sqrt|orient.d)$/) name = "`" k "`"
    printf "\n## %s\n\n![Run time against error: %s](%s)\n\n", name, k, file_of(k)
    what = unit[k] == "wrong signs" ? "signs wrong" : "error, " (unit[k] == "2^-53 of the largest" ? "u" : unit[k])
    printf "| implementation | ns: %s | %s | ns at most | greatest %s | where | failed |\n", first[k], what, what
    print "|---|---:|---:|---:|---:|---|---|"
    for (j = 1; j <= count[k]; ++j) {
      w = who[k, j]
      printf "| %s | %s | %s | %s | %s | %s | %s |\n", bold(w), time(common_ns[k, w]), common[k, w], time(most_ns[k, w]), \
        (figure(most[k, w]) (unit[k] == "wrong signs" && most[k, w] > 0 ? " %" : "")), (most[k, w] <= 0.505 ? "" : place[k, w]), \
        (most_failed[k, w] > 0 ? figure(most_failed[k, w]) " %: " failing[k, w] : "")
    }
  }
}
