# Reads results.csv; writes a picture (SVG) of run time against error for one kernel.
# Usage: awk -v kernel=line -f svg.awk -f plot.awk results.csv
BEGIN { FS = ","; panel_width = 480; panel_height = 360; left = 62; top = 44; inner_width = 220; inner_height = 270 }
$1 != kernel || $2 !~ /^(random|triangle) (8|32|128|512) px 1080p$/ { next }
{
  if (!($2 in number)) { number[$2] = ++panels; title[panels] = $2 }
  p = number[$2]
  m = ++points[p]
  name[p, m] = $3
  y[p, m] = $5 + 0
  kind[p, m] = $3 == "irg" ? "own" : $3 ~ /^irg:/ ? "variant" : $3 ~ /^limit:/ ? "limit" : "peer"
  item = $7
  if ($11 == "1/256") smooth = 1
  if (smooth) x[p, m] = $10 + 0
  else if (match($13, /[0-9]+ (cells|pixels) judged/)) x[p, m] = 1000 * $12 / (substr($13, RSTART, RLENGTH) + 0)
  if (x[p, m] > greatest) greatest = x[p, m]
}
# Errors from 0 on: nearly linear below 0.1, logarithmic above.
function across(v) { return left + 8 + (inner_width - 16) * log10(1 + v / 0.1) / log10(1 + greatest / 0.1) }
function up(v) { return top + inner_height * (1 - (log10(v) - low) / (high - low)) }
function draw_panel(p,    m, i, j, v, e, order, best, at, last, swap) {
  low = 1e9; high = -1e9
  for (m = 1; m <= points[p]; ++m) {
    v = log10(y[p, m])
    if (v < low) low = v
    if (v > high) high = v
  }
  low -= 0.1; high += 0.1
  text(left, 20, "title", "start", kernel ": " title[p])
  text(left, 36, "axis", "start", "ns per " item)
  for (e = int(low) - 1; e <= high; ++e)
    for (i = 1; i <= 5; i += i == 2 ? 3 : 1) {
      if (i == 3 || i == 4) continue
      v = i * 10 ^ e
      if (log10(v) < low || log10(v) > high) continue
      line(left, up(v), left + inner_width, up(v), "grid")
      text(left - 6, up(v) + 4, "axis", "end", v)
    }
  for (v = 0; v <= greatest * 1.001; v = v == 0 ? 0.1 : v * 10) {
    line(across(v), top, across(v), top + inner_height, "grid")
    text(across(v), top + inner_height + 16, "axis", "middle", v)
  }
  text(left + inner_width / 2, top + inner_height + 34, "axis", "middle",
    smooth ? "mean error of a pixel, 1/256 of its area" : "wrong pixels in 1000")
  # Names stand right of the panel, from the slowest down, no two on each other, tied to their points.
  for (m = 1; m <= points[p]; ++m) order[m] = m
  for (i = 1; i <= points[p]; ++i)
    for (j = i + 1; j <= points[p]; ++j)
      if (y[p, order[j]] > y[p, order[i]]) { swap = order[i]; order[i] = order[j]; order[j] = swap }
  last = top - 8
  for (i = 1; i <= points[p]; ++i) {
    m = order[i]
    at = up(y[p, m])
    best = at > last + 14 ? at : last + 14
    if (best > top + inner_height + 24 - 14 * (points[p] - i) ) {
      v = top + inner_height + 24 - 14 * (points[p] - i)
      best = v > last + 14 ? v : last + 14
    }
    last = best
    if (kind[p, m] == "limit") {
      line(left, at, left + inner_width, at, "limit")
      line(left + inner_width, at, left + inner_width + 12, best, "limit")
    } else {
      line(across(x[p, m]), at, left + inner_width + 12, best, "tie")
      printf "<circle cx=\"%.1f\" cy=\"%.1f\" r=\"%s\" class=\"%s\"/>\n", across(x[p, m]), at, kind[p, m] == "own" ? 5 : 4, kind[p, m]
    }
    text(left + inner_width + 15, best + 4, "name " kind[p, m] "-name", "start", name[p, m])
  }
}
END {
  if (!panels) exit
  if (greatest < 1) greatest = 1
  width = panel_width * (panels > 1 ? 2 : 1)
  height = panel_height * int((panels + 1) / 2)
  printf "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%d\" height=\"%d\" viewBox=\"0 0 %d %d\">\n", width, height, width, height
  print "<style>text { font: 11px sans-serif; fill: #333 } .title { font-size: 13px; font-weight: bold } .axis { fill: #666 }"
  print ".grid { stroke: #e4e4e4 } .tie { stroke: #bbb; stroke-width: 0.6 } .limit { stroke: #888; stroke-dasharray: 4 3 }"
  print ".own { fill: #0b5cad } .variant { fill: #8fbce6 } .peer { fill: #e07b00 } .own-name { font-weight: bold; fill: #0b5cad }"
  print ".peer-name { fill: #a85b00 } .limit-name { fill: #777; font-style: italic }</style>"
  printf "<rect width=\"%d\" height=\"%d\" fill=\"#fff\"/>\n", width, height
  for (p = 1; p <= panels; ++p) {
    printf "<g transform=\"translate(%d %d)\">\n", panel_width * ((p - 1) % 2), panel_height * int((p - 1) / 2)
    draw_panel(p)
    print "</g>"
  }
  print "</svg>"
}
