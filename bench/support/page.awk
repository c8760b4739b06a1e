# Reads results.csv; writes the tables of docs/raster/benchmarks.md.
BEGIN {
  FS = ","
  plain = " (plain x86-64)"
  kernels = split("line line_batch line_aa fill fill_aa", kernel, " ")
  in_series = "^(random|triangle) [0-9]+ px 1080p$"
}
NR == 1 { next }
{
  k = $1
  is_plain = index($2, plain) > 0
  name = $2
  sub(/ \(plain x86-64\)$/, "", name)
  if (!((k, name) in seen)) { seen[k, name] = 1; cases[k, ++count[k]] = name }
  if ($3 == "irg") { own[k, $2] = $5; limit[k, $2] = $8 }
  else if ($3 !~ /^(irg|limit):/ && $4 == "yes" && (!((k, $2) in best) || $5 + 0 < best[k, $2] + 0)) {
    best[k, $2] = $5
    peer[k, $2] = $3
  }
  if (is_plain) next
  if (!((k, $3) in known)) { known[k, $3] = 1; who[k, ++people[k]] = $3 }
  time[k, name, $3] = $5
  if ($4 == "no") other_work[k, $3] = 1
  unit[k] = $11 == "" ? unit[k] : $11
  if ($9 == "") next
  judged[k, $3] = 1
  if ($9 + 0 > max[k, $3]) max[k, $3] = $9 + 0
  if (name ~ in_series) {
    sum[k, $3] += $10
    parts[k, $3] += 1
  }
  wrong[k, $3] += $12
  pixels[k, $3] += $13 ~ /[0-9]+ (cells|pixels) judged/ ? judged_in($13) : 0
}
function judged_in(note) {
  match(note, /[0-9]+ (cells|pixels) judged/)
  return substr(note, RSTART, RLENGTH) + 0
}
function ns(v) { return v == "" ? "" : v >= 100 ? sprintf("%.0f", v) : sprintf("%.3g", v) }
function ratio(k, c) { return (k, c) in best ? sprintf("%.2f", own[k, c] / best[k, c]) : "" }
END {
  for (i = 1; i <= kernels; ++i) {
    k = kernel[i]
    if (!(k in count)) continue
    printf "\n## %s\n\n", k
    print "| case | irg, ns | fastest peer, ns | its name | ratio | of the limit | ratio, plain x86-64 |"
    print "|---|---|---|---|---|---|---|"
    for (j = 1; j <= count[k]; ++j) {
      c = cases[k, j]
      if (!((k, c) in own)) continue
      printf "| %s | %s | %s | %s | %s | %s | %s |\n", c, ns(own[k, c]), ns(best[k, c]), peer[k, c], ratio(k, c),
        limit[k, c] == "" ? "" : sprintf("%.2f", limit[k, c]), ratio(k, c plain)
    }
    series = 0
    for (j = 1; j <= count[k]; ++j)
      if (cases[k, j] ~ in_series) column[++series] = cases[k, j]
    if (!series) continue
    printf "\nTime and error side by side: ns for %s", column[1]
    for (j = 2; j <= series; ++j) printf ", %s", column[j]
    printf ". The mean error is theirs; the greatest error and the wrong ones are those of all cases above. Errors in %s.\n\n|  |", unit[k]
    for (j = 1; j <= series; ++j) { split(column[j], word, " "); printf " %s px |", word[2] }
    print " greatest error | mean error | wrong per 1000 |"
    printf "|---|---|---|---|"
    for (j = 1; j <= series; ++j) printf "---|"
    print ""
    for (p = 1; p <= people[k]; ++p) {
      w = who[k, p]
      printf "| %s%s |", w, other_work[k, w] ? " (other work)" : ""
      for (j = 1; j <= series; ++j) printf " %s |", ns(time[k, column[j], w])
      if (judged[k, w])
        printf " %.3g | %.3g | %.3g |\n", max[k, w], parts[k, w] ? sum[k, w] / parts[k, w] : 0, pixels[k, w] ? 1000 * wrong[k, w] / pixels[k, w] : 0
      else
        print " | | |"
    }
  }
}
