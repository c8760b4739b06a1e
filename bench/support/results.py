#!/usr/bin/env python3
# Makes results.csv and accuracy.csv from what Google Benchmark wrote: medians over the repetitions, and for the studies
# of accuracy the spread of the times and the worst inputs, too.
# Usage: results.py RESULTS ACCURACY CPU COMMIT JSON...
import json
import sys

RESULTS = (
    "kernel,case,implementation,same_work,ns_per_item,items,item,limit_fraction,max_error,mean_error,error_unit,wrong,note"
)
ACCURACY = (
    "kernel,distribution,implementation,items,ns_least,ns_median,ns_low,ns_high,error_unit,max_error,mean_error,"
    "p99_error,exact_percent,failed_percent,worst_input,build,cpu,commit"
)


def contenders(files):
    """The times of each benchmark's repetitions, their median with its counters, and how it was built; in order."""
    for name in files:
        try:
            with open(name, encoding="utf-8") as file:
                report = json.load(file)
        except (OSError, ValueError) as problem:  # the program did not come to its end
            print(f"{name} is left out: {problem}", file=sys.stderr)
            continue
        found = {}
        for run in report["benchmarks"]:
            if run.get("error_occurred"):
                continue
            times, _ = found.setdefault(run["run_name"], ([], {}))
            if run["run_type"] == "iteration":
                times.append(run["ns_per_item"])
            if run["repetitions"] == 1 or run.get("aggregate_name") == "median":
                found[run["run_name"]] = times, run
        for times, median in found.values():
            yield sorted(times), median, report["context"]["build"]


def row(values):
    return ",".join(str(v).replace(",", ";") for v in values) + "\n"


def main(results_name, accuracy_name, cpu, commit, *files):
    with open(results_name, "w", encoding="utf-8") as results, open(accuracy_name, "w", encoding="utf-8") as accuracy:
        results.write(RESULTS + "\n")
        accuracy.write(ACCURACY + "\n")
        for times, median, build in contenders(files):
            kernel, case, who = median["run_name"].split("/")[:3]
            item, unit, same_work, worst_input, note = median["label"].split("\t", 4)

            def figure(name, digits):
                return f"{median[name]:.{digits}g}" if name in median else ""

            def time(share):
                return f"{times[int(share * (len(times) - 1))]:.6g}"

            results.write(row([kernel, case, who, same_work, figure("ns_per_item", 6), int(median["items"]), item,
                               figure("limit_share", 4), figure("max_error", 4), figure("mean_error", 4), unit,
                               figure("wrong", 15), note]))
            if worst_input:
                errors = [figure(name, 6) for name in ("max_error", "mean_error", "p99_error", "exact_percent",
                                                       "failed_percent")]
                accuracy.write(row([kernel, case, who, int(median["items"]), time(0), time(0.5), time(0.025),
                                    time(0.975), unit, *errors, worst_input, build, cpu, commit]))


main(*sys.argv[1:])
