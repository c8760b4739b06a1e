# What the programs that write pictures (SVG) share; they are run with it: awk -f svg.awk -f plot.awk.
function log10(v) { return log(v) / log(10) }
function text(px, py, class, anchor, words) {
  gsub(/&/, "\\&amp;", words)
  gsub(/</, "\\&lt;", words)
  printf "<text x=\"%.1f\" y=\"%.1f\" class=\"%s\" text-anchor=\"%s\">%s</text>\n", px, py, class, anchor, words
}
function line(x1, y1, x2, y2, class) {
  printf "<line x1=\"%.1f\" y1=\"%.1f\" x2=\"%.1f\" y2=\"%.1f\" class=\"%s\"/>\n", x1, y1, x2, y2, class
}
