// SPDX-License-Identifier: MIT
#include "support/measure.hpp"

#ifdef __linux__
#include <sched.h>
#endif

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <map>
#include <ostream>

#include <benchmark/benchmark.h>

namespace bench {

bool smoke() { return std::getenv("IRG_BENCH_SMOKE") != nullptr; }

void stay_on_this_processor() {
#ifdef __linux__
  const int processor = sched_getcpu();
  if (processor < 0) return;
  cpu_set_t set;
  CPU_ZERO(&set);
  CPU_SET(static_cast<std::size_t>(processor), &set);
  sched_setaffinity(0, sizeof set, &set);
#endif
}

void keep_alive(std::shared_ptr<void> what) {
  static std::vector<std::shared_ptr<void>> all;
  all.push_back(std::move(what));
}

namespace {

struct entry {
  contest where;
  contender who;
  errors found{};
  bool judged = false;
};

std::map<std::string, std::shared_ptr<entry>> entries;  // by the names of the benchmarks
int broken_promises = 0;

std::string name_of(const contest& c, const std::string& who) { return c.kernel + "/" + c.test_case + "/" + who; }

void judge(entry& e) {
  e.judged = true;
  if (e.who.judge) e.found = e.who.judge();
  if (e.found.broken.empty()) return;
  ++broken_promises;
  std::fprintf(stderr, "%s: broken promise: %s\n", name_of(e.where, e.who.name).c_str(), e.found.broken.c_str());
}

// What the counters cannot say, for the table and for results.py, with tabs between: item, unit of the errors, whether
// it is the same work, worst input, note.
std::string label_of(const entry& e) {
  const std::string &a = e.who.note, &b = e.found.note;
  return e.where.item + "\t" + (e.who.judge ? e.where.error_unit : "") + (e.who.same_work ? "\tyes\t" : "\tno\t") +
         e.found.worst_input + "\t" + a + (a.empty() || b.empty() ? "" : "; ") + b;
}

// Each turn begins with a run that is not measured, so that nobody pays for what the one before left in the caches; who
// says how long it took has one of them in all.
void measure(benchmark::State& state, entry& e) {
  if (e.who.seconds) {
    if (!e.judged && !smoke()) (void)e.who.seconds();
    for (auto _ : state) {
      const double taken = e.who.seconds();
      if (!(taken >= 0)) return state.SkipWithError("cannot run here");
      state.SetIterationTime(taken);
    }
  } else {
    if (!smoke()) e.who.run();
    for (auto _ : state) e.who.run();
  }
  if (!e.judged) judge(e);
  using benchmark::Counter;
  state.counters["ns_per_item"] =
      Counter(1e-9 * static_cast<double>(e.where.items), Counter::kIsIterationInvariantRate | Counter::kInvert);
  state.counters["items"] = static_cast<double>(e.where.items);
  const auto add = [&](const std::string& name, double value) {
    if (!std::isnan(value)) state.counters[name] = value;
  };
  add("max_error", e.found.max);
  add("mean_error", e.found.mean);
  add("wrong", e.found.wrong);
  for (const auto& [name, value] : e.found.more) add(name, value);
  state.SetLabel(label_of(e));
}

using run_list = std::vector<benchmark::BenchmarkReporter::Run>;

// A table for each contest, a line for each contender: medians, and how the turns vary.
class table : public benchmark::BenchmarkReporter {
public:
  bool ReportContext(const Context& context) override {
    PrintBasicContext(&GetErrorStream(), context);
    return true;
  }
  void ReportRuns(const run_list& runs) override {
    std::map<std::string, double> variation;
    for (const Run& r : runs)
      if (r.aggregate_name == "cv") variation[r.run_name.function_name] = r.counters.at("ns_per_item");
    std::string title;
    for (const Run& r : runs) {
      if (r.repetitions > 1 && r.aggregate_name != "median" && !r.error_occurred) continue;
      const auto& [where, who, found, judged] = *entries.at(r.run_name.function_name);
      const std::string here = where.kernel + " / " + where.test_case;
      if (here != title) {
        print("\n%s: time of a %s, %lld in a run%s%s\n  %-34s %10s %6s %9s %10s %10s %8s\n", here.c_str(),
              where.item.c_str(), static_cast<long long>(where.items), where.error_unit.empty() ? "" : "; errors in ",
              where.error_unit.c_str(), "", "ns", "+- %", "of limit", "max error", "mean error", "wrong");
        title = here;
      }
      print("  %-34s", who.name.c_str());
      if (r.error_occurred) {
        print(" %s\n", r.error_message.c_str());
        continue;
      }
      print(" %10.4g %6.1f", static_cast<double>(r.counters.at("ns_per_item")),
            100 * variation[r.run_name.function_name]);
      for (const auto& [name, width] :
           {std::pair{"limit_share", 9}, {"max_error", 10}, {"mean_error", 10}, {"wrong", 8}}) {
        const auto found_counter = r.counters.find(name);
        if (found_counter == r.counters.end())
          print(" %*s", width, "");
        else
          print(" %*.4g", width, static_cast<double>(found_counter->second));
      }
      print("%s%s\n", "  ", r.report_label.substr(r.report_label.rfind('\t') + 1).c_str());
    }
  }

private:
  template <class... Words>
  void print(const char* format, Words... words) {
    char line[400];
    std::snprintf(line, sizeof line, format, words...);
    GetOutputStream() << line;
  }
};

// The benchmarks end in random order; here they are put into that of their entry, each with its share of the limit.
class in_order : public benchmark::BenchmarkReporter {
public:
  explicit in_order(std::unique_ptr<BenchmarkReporter> to) : to_(std::move(to)) {}
  bool ReportContext(const Context& context) override {
    to_->SetOutputStream(&GetOutputStream());
    to_->SetErrorStream(&GetErrorStream());
    return to_->ReportContext(context);
  }
  void ReportRuns(const run_list& runs) override { all_.insert(all_.end(), runs.begin(), runs.end()); }
  void Finalize() override {
    std::map<std::string, std::int64_t> first;  // of a contest's contenders, which need not have been entered in a row
    for (const Run& r : all_) {
      auto& least = first.try_emplace(name_of(contest_of(r), ""), r.family_index).first->second;
      least = std::min(least, r.family_index);
    }
    std::stable_sort(all_.begin(), all_.end(), [&](const Run& a, const Run& b) {
      return std::pair(first[name_of(contest_of(a), "")], a.family_index) <
             std::pair(first[name_of(contest_of(b), "")], b.family_index);
    });
    const auto counts = [](const Run& r) {
      return r.aggregate_name == "median" || (r.repetitions == 1 && !r.error_occurred);
    };
    std::map<std::string, double> medians;
    for (const Run& r : all_)
      if (counts(r)) medians[r.run_name.function_name] = r.counters.at("ns_per_item");
    for (Run& r : all_) {
      const auto limit = medians.find(name_of(contest_of(r), contest_of(r).limit));
      if (counts(r) && limit != medians.end()) r.counters["limit_share"] = limit->second / r.counters.at("ns_per_item");
    }
    to_->ReportRuns(all_);
    to_->Finalize();
  }

private:
  static const contest& contest_of(const Run& r) { return entries.at(r.run_name.function_name)->where; }

  std::unique_ptr<BenchmarkReporter> to_;
  run_list all_{};
};

}  // namespace

void enter(const contest& c, contender who) {
  const std::string name = name_of(c, who.name);
  auto e = std::make_shared<entry>(entry{c, std::move(who)});
  const bool whole = std::count(name.begin(), name.end(), '/') == 2;
  if (!whole || !entries.emplace(name, e).second) {
    std::fprintf(stderr, "%s: %s\n", name.c_str(), whole ? "entered twice" : "a name has a slash");
    std::abort();
  }
  auto* made = benchmark::RegisterBenchmark(name.c_str(), [e](benchmark::State& state) { measure(state, *e); });
  if (e->who.seconds)
    made->UseManualTime()->Iterations(1);
  else
    made->MeasureProcessCPUTime();
}

int run_benchmarks(int argc, char** argv) {
  std::vector<std::string> words{argv[0], "--benchmark_enable_random_interleaving=true",
                                 smoke() ? "--benchmark_repetitions=1" : "--benchmark_repetitions=11",
                                 smoke() ? "--benchmark_min_time=0" : "--benchmark_min_time=0.003"};
  words.insert(words.end(), argv + 1, argv + argc);  // the last of a kind counts
  std::vector<char*> pointers;
  bool to_json = false, to_file = false;
  for (std::string& word : words) {
    pointers.push_back(word.data());
    if (word.starts_with("--benchmark_out=")) to_file = to_json = true;
    if (word.starts_with("--benchmark_out_format=") && !word.ends_with("=json")) to_file = false;
  }
  int count = static_cast<int>(pointers.size());
  pointers.push_back(nullptr);
  benchmark::AddCustomContext("build", IRG_BENCH_BUILD);
  benchmark::Initialize(&count, pointers.data());
  if (benchmark::ReportUnrecognizedArguments(count, pointers.data())) return 1;
  stay_on_this_processor();
  std::unique_ptr<benchmark::BenchmarkReporter> format(benchmark::CreateDefaultDisplayReporter());
  if (dynamic_cast<benchmark::ConsoleReporter*>(format.get())) format = std::make_unique<table>();
  in_order display(std::move(format)), file(std::make_unique<benchmark::JSONReporter>());
  benchmark::RunSpecifiedBenchmarks(&display, to_file && to_json ? &file : nullptr);
  if (broken_promises > 0) std::fprintf(stderr, "%d promises broken\n", broken_promises);
  return broken_promises > 0;
}

}  // namespace bench
