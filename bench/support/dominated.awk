# Reads accuracy.csv; lists the variants of irg that are dominated - another implementation is at least as fast within
# 5 % and at least as right, and better in one of the two - in all distributions of their kernel, or in all but one: the
# doc comments of the latter name that distribution, the former go.
function right(row) { return exact[row] == 100 ? 0 : worst[row] }  # correctly rounded ones are equally right
function dominates(a, b) {
  if (ns[a] > 1.05 * ns[b] || failed[a] > failed[b] || right(a) > right(b)) return 0
  return ns[b] > 1.05 * ns[a] || failed[a] < failed[b] || right(a) < right(b)
}
BEGIN { FS = "," }
FNR == 1 { for (i = 1; i <= NF; ++i) column[$i] = i; next }
$column["ns_median"] > 0 {
  ++rows
  panel[rows] = $1 FS $2
  name[rows] = $3
  ns[rows] = $column["ns_median"] + 0
  worst[rows] = $column["max_error"] + 0
  exact[rows] = $column["exact_percent"] + 0
  failed[rows] = $column["failed_percent"] + 0
}
END {
  for (a = 1; a <= rows; ++a) {
    if (name[a] !~ /^irg/) continue
    split(panel[a], words, FS)
    variant = words[1] FS name[a]
    if (!(variant in met)) order[++variants] = variant
    ++met[variant]
    by = ""
    for (b = 1; b <= rows; ++b)
      if (panel[b] == panel[a] && name[b] != name[a] && dominates(b, a)) by = by (by == "" ? "" : ", ") name[b]
    if (by == "") { ++free[variant]; where[variant] = words[2] }
    if (by != "" && !((variant, by) in said)) { said[variant, by] = 1; rivals[variant] = rivals[variant] (rivals[variant] == "" ? "" : "; ") by }
  }
  for (i = 1; i <= variants; ++i) {
    variant = order[i]
    if (free[variant] > 1 || (met[variant] == 1 && free[variant] == 1)) continue
    split(variant, words, FS)
    printf "%s, %s: dominated %s (by %s)\n", words[1], words[2], free[variant] == 0 ? "in every distribution" : "but for \"" where[variant] "\"", rivals[variant]
  }
}
