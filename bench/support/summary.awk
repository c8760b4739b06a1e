# Reads results.csv; prints, case by case, irg beside the fastest peer: time, ratio, errors, and how near the limit.
# Peers of other work (same_work is no) have a column of their own and do not count for the ratio.
BEGIN { FS = "," }
NR == 1 { next }
{
  key = $1 " / " $2
  if (!(key in seen)) { seen[key] = 1; order[++n] = key; if (length(key) > width) width = length(key) }
  if ($3 == "irg") { own[key] = $5; item[key] = $7; limit[key] = $8; own_error[key] = error() }
  else if ($3 ~ /^(irg|limit):/) next
  else if ($4 == "no") {
    if (!(key in other) || $5 + 0 < other[key] + 0) { other[key] = $5; other_name[key] = $3 }
  } else if (!(key in best) || $5 + 0 < best[key] + 0) { best[key] = $5; peer[key] = $3; peer_error[key] = error() }
}
function error() { return $9 == "" ? "-" : sprintf("%s %s, %s", $9, $11, $12) }
function ns(v) { return v == "" ? "-" : v >= 100 ? sprintf("%.0f", v) : sprintf("%.3g", v) }
END {
  format = "%-" width "s %9s %9s %6s %6s  %-18s %-18s %s\n"
  printf format, "kernel / case", "irg, ns", "peer, ns", "ratio", "limit", "irg: error, wrong", "peer: error, wrong",
    "fastest peer"
  for (i = 1; i <= n; ++i) {
    key = order[i]
    if (!(key in own)) continue
    text = (key in best) ? peer[key] : "no peer"
    if (key in other) text = text sprintf("; other work: %s %s, ratio %.2f", other_name[key], ns(other[key]), own[key] / other[key])
    printf format, key, ns(own[key]), ns(best[key]), (key in best) ? sprintf("%.2f", own[key] / best[key]) : "-",
      limit[key] == "" ? "-" : sprintf("%.2f", limit[key]), own_error[key], (key in best) ? peer_error[key] : "-", text
  }
  print ""
  print "ratio: irg's time over that of the fastest peer of the same work; below 1 means irg is faster. limit: the time of"
  print "the limit over irg's; about 1 is as fast as known pixels are written one after the other, more is possible where"
  print "memory is fetched ahead. error: the greatest of the sample, in pixels or in 1/256 of a pixel's area; wrong: how many"
  print "pixels of the sample are wrong. (plain x86-64): built without -march."
}
