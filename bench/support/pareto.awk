# Reads accuracy.csv; writes a picture (SVG) of run time against error for one kernel, a panel for each distribution.
# Filled marks are greatest errors, hollow ones mean errors; the line joins what nothing else beats in both.
# Usage: awk -v kernel=angle -f pareto.awk accuracy.csv
BEGIN { FS = ","; panel_width = 470; panel_height = 300; left = 60; top = 44; inner_width = 210; inner_height = 200 }
$1 != kernel { next }
{
  if (!($2 in number)) { number[$2] = ++panels; title[panels] = $2 }
  p = number[$2]
  m = ++points[p]
  name[p, m] = $3
  ns[p, m] = $5 + 0
  worst[p, m] = $9 + 0
  mean[p, m] = $10 + 0
  note[p, m] = sprintf("%.3g %% exact", $11) ($12 > 0 ? sprintf(", %.3g %% failed", $12) : "")
  kind[p, m] = $3 == "irg" ? "own" : $3 ~ /^irg/ ? "variant" : "peer"
  failed[p, m] = $12 + 0
  unit = $8
  v = log10($5 + 0)
  if (low_ns == "" || v < low_ns) low_ns = v
  if (high_ns == "" || v > high_ns) high_ns = v
  for (c = 9; c <= 10; ++c) if ($c > 0) {
    v = log10($c + 0)
    if (low_error == "" || v < low_error) low_error = v
    if (high_error == "" || v > high_error) high_error = v
  }
}
function log10(v) { return log(v) / log(10) }
function across(v) { return left + inner_width * (log10(v) - low_ns) / (high_ns - low_ns) }
# Errors below the least that is shown, 0 too, stand on the lowest line.
function up(v,    l) {
  l = v > 0 ? log10(v) : low_error
  if (l < low_error) l = low_error
  return top + inner_height * (1 - (l - low_error) / (high_error - low_error))
}
function text(px, py, class, anchor, words) {
  gsub(/&/, "\\&amp;", words)
  gsub(/</, "\\&lt;", words)
  printf "<text x=\"%.1f\" y=\"%.1f\" class=\"%s\" text-anchor=\"%s\">%s</text>\n", px, py, class, anchor, words
}
function line(x1, y1, x2, y2, class) {
  printf "<line x1=\"%.1f\" y1=\"%.1f\" x2=\"%.1f\" y2=\"%.1f\" class=\"%s\"/>\n", x1, y1, x2, y2, class
}
function short(v) { return v >= 10000 || (v > 0 && v < 0.001) ? sprintf("1e%d", int(log10(v) + (v < 1 ? -0.5 : 0.5))) : v + 0 }
function draw_panel(p,    e, step, m, i, j, swap, order, best, lastx, lasty, at, wanted, place) {
  text(left, 18, "title", "start", title[p])
  text(left, 34, "axis", "start", "error in " unit)
  for (e = int(low_ns) - 1; e <= high_ns; ++e) {
    if (e < low_ns) continue
    line(across(10 ^ e), top, across(10 ^ e), top + inner_height, "grid")
    text(across(10 ^ e), top + inner_height + 16, "axis", "middle", short(10 ^ e))
  }
  step = high_error - low_error > 40 ? 20 : high_error - low_error > 12 ? 4 : high_error - low_error > 5 ? 2 : 1
  for (e = -320; e <= high_error; e += step) {
    if (e < low_error) continue
    line(left, up(10 ^ e), left + inner_width, up(10 ^ e), "grid")
    text(left - 6, up(10 ^ e) + 4, "axis", "end", short(10 ^ e))
  }
  text(left + inner_width / 2, top + inner_height + 32, "axis", "middle", "ns")
  # The front: from the fastest on, every one that never fails with a lesser error than all that are faster.
  for (m = 1; m <= points[p]; ++m) order[m] = m
  for (i = 1; i <= points[p]; ++i)
    for (j = i + 1; j <= points[p]; ++j)
      if (ns[p, order[j]] < ns[p, order[i]]) { swap = order[i]; order[i] = order[j]; order[j] = swap }
  best = ""
  for (i = 1; i <= points[p]; ++i) {
    m = order[i]
    if (failed[p, m] > 0 || (best != "" && worst[p, m] >= best)) continue
    if (best != "") {
      line(lastx, lasty, across(ns[p, m]), lasty, "front")
      line(across(ns[p, m]), lasty, across(ns[p, m]), up(worst[p, m]), "front")
    }
    best = worst[p, m]; lastx = across(ns[p, m]); lasty = up(best)
  }
  # Names stand right of the panel, from the greatest error down, no two on each other and none below.
  for (i = 1; i <= points[p]; ++i)
    for (j = i + 1; j <= points[p]; ++j)
      if (worst[p, order[j]] > worst[p, order[i]]) { swap = order[i]; order[i] = order[j]; order[j] = swap }
  at = top - 16
  for (i = 1; i <= points[p]; ++i) {
    wanted = up(worst[p, order[i]]) - 4
    place[i] = at = wanted > at + 26 ? wanted : at + 26
  }
  at = top + inner_height + 50
  for (i = points[p]; i >= 1; --i) {
    if (place[i] > at - 26) place[i] = at - 26
    at = place[i]
  }
  for (i = 1; i <= points[p]; ++i) {
    m = order[i]
    at = place[i]
    printf "<circle cx=\"%.1f\" cy=\"%.1f\" r=\"4\" class=\"%s\"/>\n", across(ns[p, m]), up(worst[p, m]), kind[p, m]
    printf "<circle cx=\"%.1f\" cy=\"%.1f\" r=\"3\" class=\"%s hollow\"/>\n", across(ns[p, m]), up(mean[p, m]), kind[p, m]
    line(across(ns[p, m]), up(worst[p, m]), left + inner_width + 12, at, "lead")
    text(left + inner_width + 16, at + 4, kind[p, m] == "peer" ? "name" : "name own-name", "start", name[p, m])
    text(left + inner_width + 16, at + 15, "axis", "start", note[p, m])
  }
}
END {
  if (panels == 0) exit
  if (low_error == "") { low_error = -1; high_error = 1 }
  low_ns -= 0.1; high_ns += 0.1
  if (high_error - low_error < 1) high_error = low_error + 1
  low_error -= (high_error - low_error) * 0.04; high_error += (high_error - low_error) * 0.04
  columns = panels < 2 ? 1 : 2
  rows = int((panels + columns - 1) / columns)
  printf "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%d\" height=\"%d\" font-family=\"sans-serif\">\n", columns * panel_width, rows * panel_height
  print "<style>.title{font-size:14px;font-weight:bold}.axis{font-size:10px;fill:#666}.name{font-size:11px}.own-name{font-weight:bold}" \
    ".grid{stroke:#e2e2de}.lead{stroke:#ccc}.front{stroke:#3c74b0;stroke-width:1.5}.own{fill:#cc6048;stroke:#cc6048}" \
    ".variant{fill:#e0a03c;stroke:#e0a03c}.peer{fill:#777;stroke:#777}.hollow{fill:#fff}</style>"
  print "<rect width=\"100%\" height=\"100%\" fill=\"#fafaf6\"/>"
  for (p = 1; p <= panels; ++p) {
    printf "<g transform=\"translate(%d,%d)\">\n", (p - 1) % columns * panel_width, int((p - 1) / columns) * panel_height
    draw_panel(p)
    print "</g>"
  }
  print "</svg>"
}
