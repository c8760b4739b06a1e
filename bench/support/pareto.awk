# Reads accuracy.csv; writes a picture (SVG) of run time against error for one kernel, a panel for each distribution. A
# mark is the greatest error, the dot on its stem the mean one, the bar across it goes from the least to the 97.5th
# percentile of the times; the line joins what never fails and nothing else beats in both.
# Usage: awk -v kernel=angle -f svg.awk -f pareto.awk accuracy.csv
BEGIN { FS = ","; left = 56; top = 40; inner_width = 220; lane = 22; names = 215; panel_width = left + inner_width + names + 130; lowest = 0.1 }
FNR == 1 { for (i = 1; i <= NF; ++i) column[$i] = i; next }
$1 != kernel { next }
{
  if (!($2 in number)) { number[$2] = ++panels; title[panels] = $2 }
  if (!($3 in shape)) {
    kind[$3] = $3 == "irg" ? "own" : $3 ~ /^irg/ ? "variant" : "peer"
    shape[$3] = kind[$3] == "peer" ? peers++ : kind[$3] == "own" ? 0 : ++variants
  }
  p = number[$2]
  m = ++points[p]
  if (m > most) most = m
  unit = $column["error_unit"]
  signs = unit == "wrong signs"
  name[p, m] = $3
  ns[p, m] = $column["ns_median"] + 0
  least[p, m] = $column["ns_least"] + 0
  high[p, m] = $column["ns_high"] + 0
  exact[p, m] = $column["exact_percent"] + 0
  failed[p, m] = $column["failed_percent"] + 0
  worst[p, m] = signs ? failed[p, m] : $column["max_error"] > 1e300 ? 1e300 : $column["max_error"] + 0
  mean[p, m] = signs ? worst[p, m] : $column["mean_error"] + 0
  in_lane[p, m] = !signs && failed[p, m] > 0
  if (in_lane[p, m]) lanes = has_lane[p] = 1
  else if (worst[p, m] > highest_of[p]) highest_of[p] = worst[p, m]
  if (low_ns == "" || log10(least[p, m]) < low_ns) low_ns = log10(least[p, m])
  if (high_ns == "" || log10(high[p, m]) > high_ns) high_ns = log10(high[p, m])
}
function across(v) { return left + inner_width * (log10(v) - low_ns) / (high_ns - low_ns) }
# What is below the least error shown, 0 too, stands on the lowest line.
function up(v) { return top + lane + height * (1 - (v > lowest ? log10(v / lowest) / log10(highest / lowest) : 0)) }
function power(v,    e) {  # of ten, as text
  e = int(log10(v) + (v < 1 ? -0.5 : 0.5))
  return e < -2 || e > 3 ? "10<tspan dy=\"-4\" font-size=\"8\">" e "</tspan>" : v + 0
}
function tick(px, py, anchor, v) { printf "<text x=\"%.1f\" y=\"%.1f\" class=\"axis\" text-anchor=\"%s\">%s</text>\n", px, py, anchor, power(v) }
# Ones that coincide are told apart by their shapes: those of peers are outlines.
function mark(x, y, who,    s, d) {
  s = shape[who] % 8
  if (s == 0) d = "M-4.5,0a4.5,4.5 0 1,0 9,0a4.5,4.5 0 1,0 -9,0z"
  else if (s == 1) d = "M-4,-4h8v8h-8z"
  else if (s == 2) d = "M0,-6L5,0L0,6L-5,0z"
  else if (s == 3) d = "M0,-5.5L5,4H-5z"
  else if (s == 4) d = "M0,5.5L5,-4H-5z"
  else if (s == 5) d = "M-5,0H5M0,-5V5"
  else if (s == 6) d = "M-4,-4L4,4M-4,4L4,-4"
  else d = "M-5,0H5M-2.5,-4.3L2.5,4.3M-2.5,4.3L2.5,-4.3"
  printf "<path transform=\"translate(%.1f,%.1f)\" d=\"%s\" class=\"%s\"/>\n", x, y, d, kind[who]
}
function axes(    e, k, decades, factors, step, width) {
  width = high_ns - low_ns
  split(width > 1.6 ? "1" : "1 2 5", factors, " ")
  step = width > 6 ? 2 : 1
  for (e = int(low_ns) - 1; e <= high_ns; e += step)
    for (k = 1; k in factors; ++k) {
      if (log10(factors[k] * 10 ^ e) < low_ns || log10(factors[k] * 10 ^ e) > high_ns) continue
      line(across(factors[k] * 10 ^ e), top + lane, across(factors[k] * 10 ^ e), top + lane + height, "grid")
      tick(across(factors[k] * 10 ^ e), top + lane + height + 15, "middle", factors[k] * 10 ^ e)
    }
  text(left + inner_width / 2, top + lane + height + 28, "axis", "middle", "ns")
  decades = log10(highest / lowest)
  step = decades > 100 ? 50 : decades > 30 ? 10 : decades > 14 ? 5 : decades > 6 ? 2 : 1
  for (e = int(log10(lowest) + (signs ? 1.5 : 0.5)); e <= log10(highest); e += step) {
    line(left, up(10 ^ e), left + inner_width, up(10 ^ e), "grid")
    if (up(0) - up(10 ^ e) > 9) tick(left - 6, up(10 ^ e) + 4, "end", 10 ^ e)  # else it would stand on the 0
  }
  line(left, up(0), left + inner_width, up(0), "axis-line")
  text(left - 6, up(0) + 4, "axis", "end", "0")
}
function draw_panel(p,    m, i, j, swap, order, best, last_x, last_y, x, y, row) {
  highest = 1.5 * (highest_of[p] > 100 || signs ? (signs ? 100 : highest_of[p]) : 100)
  text(left, 16, "title", "start", title[p])
  text(left, 31, "axis", "start", signs ? "% of signs wrong" : "error, " unit)
  if (p in has_lane) text(left - 6, top + 13, "axis", "end", "failed")
  if (p in has_lane) printf "<rect x=\"%d\" y=\"%d\" width=\"%d\" height=\"%d\" class=\"lane\"/>\n", left, top, inner_width, lane - 4
  axes()
  # The front: from the fastest on, every one that never fails with a lesser error than all that are faster.
  for (m = 1; m <= points[p]; ++m) order[m] = m
  for (i = 1; i <= points[p]; ++i)
    for (j = i + 1; j <= points[p]; ++j)
      if (ns[p, order[j]] < ns[p, order[i]]) { swap = order[i]; order[i] = order[j]; order[j] = swap }
  best = ""
  for (i = 1; i <= points[p]; ++i) {
    m = order[i]
    if (in_lane[p, m] || (best != "" && worst[p, m] >= best)) continue
    x = across(ns[p, m]); y = up(worst[p, m])
    if (best != "") { line(last_x, last_y, x, last_y, "front"); line(x, last_y, x, y, "front") }
    best = worst[p, m]; last_x = x; last_y = y
  }
  # irg last, on top of the others.
  for (m = points[p]; m >= 1; --m) {
    x = across(ns[p, m]); y = in_lane[p, m] ? top + lane / 2 - 2 : up(worst[p, m])
    line(across(least[p, m]), y, across(high[p, m]), y, "spread " kind[name[p, m]])
    if (!in_lane[p, m] && up(mean[p, m]) - y > 6) {
      line(x, y, x, up(mean[p, m]), "stem")
      printf "<circle cx=\"%.1f\" cy=\"%.1f\" r=\"1.8\" class=\"mean\"/>\n", x, up(mean[p, m])
    }
    mark(x, y, name[p, m])
  }
  x = left + inner_width + 18
  text(x + names + 44, top + 4, "axis", "end", signs ? "right %" : "exact %")
  if (!signs) text(x + names + 94, top + 4, "axis", "end", "failed %")
  for (m = 1; m <= points[p]; ++m) {
    row = top + 6 + 15 * m
    mark(x, row - 3.5, name[p, m])
    text(x + 10, row, kind[name[p, m]] == "peer" ? "name" : "name own-name", "start", name[p, m])
    text(x + names + 44, row, "figure", "end", sprintf("%.3g", exact[p, m]))
    if (!signs && failed[p, m] > 0) text(x + names + 94, row, "figure bad", "end", sprintf("%.3g", failed[p, m]))
  }
}
END {
  if (panels == 0) exit
  low_ns -= 0.08; high_ns += 0.08
  if (high_ns - low_ns < 0.5) high_ns = low_ns + 0.5
  if (signs) lowest = 0.01
  height = 15 * most > 150 ? 15 * most : 150
  if (!lanes) lane = 8
  panel_height = top + lane + height + 44
  columns = panels < 2 ? 1 : 2
  rows = int((panels + columns - 1) / columns)
  printf "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 %d %d\" width=\"%d\" height=\"%d\" font-family=\"sans-serif\">\n", \
    columns * panel_width, rows * panel_height, columns * panel_width, rows * panel_height
  print "<style>.title{font-size:14px;font-weight:bold}.axis{font-size:10px;fill:#555}.name{font-size:11px}.own-name{font-weight:bold}" \
    ".figure{font-size:10px}.bad{fill:#d55e00}.grid{stroke:#e4e4e4}.axis-line{stroke:#999}.lane{fill:#f0e9e4}.stem{stroke:#bbb}.mean{fill:#777}" \
    ".front{stroke:#56b4e9;stroke-width:2}.own{fill:#d55e00;stroke:#d55e00}.variant{fill:#f0c050;stroke:#8a5a00}" \
    ".peer{fill:none;stroke:#0a4a78;stroke-width:1.3}.spread{stroke-width:1;opacity:0.6}</style>"
  print "<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>"
  for (p = 1; p <= panels; ++p) {
    printf "<g transform=\"translate(%d,%d)\">\n", (p - 1) % columns * panel_width, int((p - 1) / columns) * panel_height
    draw_panel(p)
    print "</g>"
  }
  print "</svg>"
}
