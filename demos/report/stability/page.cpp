#include "demos/report/stability/page.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

#include "delassus/whole_file.h"
#include "demos/report/csv.h"
#include "demos/report/figure.h"
#include "demos/report/machine.h"
#include "demos/report/markdown.h"
#include "demos/report/stability/strips.h"
#include "demos/table.h"

namespace demos::report::stability {

namespace {

namespace fs = std::filesystem;

/// The results of one solver in one precision in a sweep.
struct Track {
  std::string method, precision;
  std::vector<double> values;
  std::vector<Verdict> verdicts;
  std::vector<std::map<std::string, double>> numbers;  ///< a map for each value
};

const std::vector<std::string> shown{
    "steps",           "steps_wanted", "worst_error",    "residual_max", "first_error",
    "first_certified", "last_error",   "last_certified", "energy_gain",  "ms",
    "out_of_budget",   "incompatible", "non_finite",     "left_out",     "fallbacks"};

std::vector<Track> readTracks(const fs::path& out, const SweepGroup& group, const Sweep& sweep,
                              const MapPlan& plan) {
  std::vector<Track> tracks;
  for (const Method& method : plan.methods)
    for (const char* precision : precisions) {
      const fs::path file = out / "stability" / precision / group.name / (sweep.name + ".csv");
      if (!fs::exists(file)) continue;
      const CsvTable table = CsvTable::read(file);
      Track track{method.name, precision, {}, {}, {}};
      for (int row = 0; row < table.rows(); ++row) {
        if (table.text(row, "method") != method.name) continue;
        track.values.push_back(table.number(row, "value"));
        track.verdicts.push_back(verdictOf(table.text(row, "verdict")));
        track.numbers.emplace_back();
        for (const std::string& name : shown) track.numbers.back()[name] = table.number(row, name);
      }
      if (!track.values.empty()) tracks.push_back(track);
    }
  return tracks;
}

/// "a → b" from `word` of the first and the last value, or a single word if both are the same.
std::string fromTo(const Track& track,
                   const std::function<std::string(const std::map<std::string, double>&)>& word) {
  const std::string first = word(track.numbers.front()), last = word(track.numbers.back());
  return first == last ? first : first + " → " + last;
}

std::string fromTo(const Track& track, const std::string& column) {
  return fromTo(track, [&column](const auto& numbers) -> std::string {
    const double value = numbers.at(column);
    return std::isfinite(value) ? shortNumber(value, 2) : "–";
  });
}

/// The error of the motion of the "first" or "last" step; in brackets unless it was compared with a
/// certified motion.
std::string motionErrors(const Track& track, const std::string& step) {
  return fromTo(track, [&step](const auto& numbers) -> std::string {
    const double error = numbers.at(step + "_error");
    if (!std::isfinite(error)) return "–";
    const std::string number = shortNumber(error, 2);
    return numbers.at(step + "_certified") > 0 ? number : '(' + number + ')';
  });
}

/// What was reported where a track first fails; nothing if it holds throughout.
std::string saidPastLimit(const Track& track) {
  std::size_t at = track.verdicts.size();
  for (std::size_t i = 0; i < track.verdicts.size() && at == track.verdicts.size(); ++i)
    if (!holds(track.verdicts[i])) at = i;
  if (at == track.verdicts.size()) return "";
  const auto& numbers = track.numbers[at];
  std::string said;
  for (const auto& [column, words] :
       std::vector<std::pair<std::string, std::string>>{{"out_of_budget", "out of budget"},
                                                        {"incompatible", "incompatible"},
                                                        {"non_finite", "not finite"},
                                                        {"left_out", "left out"},
                                                        {"fallbacks", "gave up"}}) {
    if (!(numbers.at(column) > 0)) continue;
    said += (said.empty() ? "" : ", ") + words + " in " + shortNumber(numbers.at(column), 6);
  }
  const std::string head = toString(track.verdicts[at]) + " at " + tic(track.values[at]);
  if (track.verdicts[at] == Verdict::TooSlow || track.verdicts[at] == Verdict::Crashes) return head;
  return head + (said.empty() ? ": nothing reported" : ": " + said) + " of " +
         shortNumber(numbers.at("steps"), 6) + " steps";
}

std::string detailOf(const std::vector<Track>& tracks) {
  MarkdownTable table({"solver", "holds", "worst error", "residual m/s", "motion error, first step",
                       "last step", "energy gained J", "ms a step", "first failure"});
  for (const Track& track : tracks)
    table.add({code(track.method) + " " + track.precision, rangeOf(track.values, track.verdicts),
               fromTo(track, "worst_error"), fromTo(track, "residual_max"),
               motionErrors(track, "first"), motionErrors(track, "last"),
               fromTo(track, "energy_gain"), fromTo(track, "ms"), saidPastLimit(track)});
  return table.text();
}

StripPanel panelOf(const Sweep& sweep, const std::vector<Track>& tracks) {
  StripPanel panel;
  panel.title = sweep.title;
  panel.axis = sweep.axis;
  for (const Track& track : tracks) {
    if (track.values.size() > panel.values.size()) panel.values = track.values;
    panel.strips.push_back({track.method + " " + track.precision, track.verdicts, sweep.limit});
  }
  return panel;
}

/// The measures of one sweep.
struct Reading {
  const Sweep* sweep;
  std::vector<Track> tracks;

  /// Null if that solver was not measured in that precision.
  const Track* trackOf(const std::string& method, const std::string& precision) const {
    for (const Track& track : tracks)
      if (track.method == method && track.precision == precision) return &track;
    return nullptr;
  }
};

std::vector<Reading> readGroup(const fs::path& out, const SweepGroup& group, const MapPlan& plan) {
  std::vector<Reading> readings;
  for (const Sweep& sweep : group.sweeps) {
    Reading reading{&sweep, readTracks(out, group, sweep, plan)};
    if (!reading.tracks.empty()) readings.push_back(std::move(reading));
  }
  return readings;
}

/// One panel for each solver and precision: its tracks of all sweeps of a pair, one below the
/// other.
std::vector<StripPanel> pairPanels(const std::vector<Reading>& readings) {
  std::vector<StripPanel> panels;
  for (const Track& track : readings.front().tracks) {
    StripPanel panel{
        track.method + " " + track.precision, readings.front().sweep->axis, track.values, {}};
    for (const Reading& reading : readings)
      if (const Track* own = reading.trackOf(track.method, track.precision))
        panel.strips.push_back({reading.sweep->title, own->verdicts, reading.sweep->limit});
    panels.push_back(panel);
  }
  return panels;
}

/// A row for each sweep, a column for each solver and precision.
class Overview {
 public:
  Overview(const std::vector<Method>& methods, const std::string& rows) {
    for (const Method& method : methods)
      for (const char* precision : precisions) columns_.push_back({method.name, precision});
    std::vector<std::string> heading{rows};
    for (const auto& [method, precision] : columns_)
      heading.push_back(code(method) + " " + precision);
    table_ = MarkdownTable(heading);
  }

  void add(const std::string& name, const Reading& reading) {
    std::vector<std::string> row{name};
    for (const auto& [method, precision] : columns_) {
      const Track* track = reading.trackOf(method, precision);
      const std::string cell = track != nullptr ? rangeOf(track->values, track->verdicts) : "–";
      row.push_back(method == "delassus" ? "**" + cell + "**" : cell);
    }
    table_.add(row);
  }
  std::string text() const { return table_.text(); }

 private:
  std::vector<std::pair<std::string, std::string>> columns_;
  MarkdownTable table_{{}};
};

/// A picture and the words around it.
struct Section {
  std::vector<StripPanel> panels;
  std::string before, after;
};

std::string lawOf(const Sweep& sweep) {
  return "Law: " + sweep.law + "." + (sweep.remark.empty() ? "" : " " + sweep.remark) + "\n\n";
}

/// One sweep after the other; each is a row of the overview.
Section sweepSection(const std::vector<Reading>& readings, Overview& overview) {
  Section section;
  for (const Reading& reading : readings) {
    const Sweep& sweep = *reading.sweep;
    const std::vector<double>& values = reading.tracks[0].values;
    const std::string range = tic(values.front()) + " to " + tic(values.back());
    overview.add(sweep.title + ": *" + sweep.axis + "*, " + range, reading);
    section.panels.push_back(panelOf(sweep, reading.tracks));
    section.after += "### " + sweep.title + "\n\nHarder: " + sweep.axis + ". " + lawOf(sweep) +
                     detailOf(reading.tracks);
  }
  return section;
}

/// Two things at once, with an overview of their own.
Section pairSection(const SweepGroup& group, const std::vector<Reading>& readings,
                    const MapPlan& plan) {
  const Sweep& first = *readings.front().sweep;
  Overview overview(plan.methods, group.second);
  for (const Reading& reading : readings) overview.add(reading.sweep->title, reading);
  return {pairPanels(readings),
          "Harder: " + first.axis + "; and " + group.second + ". " + lawOf(first), overview.text()};
}

constexpr const char* legend =
    R"(Each series of trials makes one thing harder and leaves all else; the last pictures make two things harder at once, the second one
from row to row. A cell is one run:

- **holds**: the law of the series is kept, nothing was reported;
- **holds and says so** (o): the law is kept; steps that ended above the tolerance were reported (out of budget,
  incompatible demands; a stock MLCP solver: given up);
- **fails and says so** (!): the law is broken, and steps were reported;
- **fails** (x): the law is broken and nobody said a word. Stock's sweeps never report anything. Where ours does, the
  law of the step was kept to its tolerance and something else broke the motion: the time stepping, the narrow phase or
  the rounding of poses. Its residual stands in the table, the cause above it;
- **too slow** (t): it held until its time was up, or a step had no end; **crashes** (#): or asks for more than 6 GB.

A black line is where the time stepping itself ends, whatever the solver. Tables give, from the first to the last
value: the worst error, the largest natural residual of any step, errors of the motion, the energy gained, the median
time of `solveGroup`. Times were taken with both cores busy. What is lost is not followed to the end.

Error of the motion: |v − v*|/|v_f − v*| in the metric of the masses, of the first step, which is the same problem for
all, and of the step after the last one of the trial, which is each solver's own. v* is solved twice, from rest and from
the stored impulses, and both answers are refined by Newton's method in extended precision (113 bits in the law, 64 in
the linear systems) until the next step would change the motion by less than 1e-15 of |v_f − v*|. In float, v itself is
known to 1e-7. **(x)**: v* is not certified, but an answer of double precision to 1e-12: the island has more than 200
unknowns (60 contacts), or the refinement did not get there (ties between regions, contacts that are redundant but for
rounding, demands that contradict each other), or two motions were found. **–**: nothing to compare with, that is no
reaction that is more than rounding, no answer in the time that is allowed, or more than 200 unknowns after the last step.

)";

}  // namespace

std::string rangeOf(const std::vector<double>& values, const std::vector<Verdict>& verdicts) {
  std::size_t from = 0, length = 0;
  for (std::size_t i = 0, run = 0; i < verdicts.size(); ++i) {
    run = holds(verdicts[i]) ? run + 1 : 0;
    if (run > length) {
      length = run;
      from = i + 1 - run;
    }
  }
  if (length == 0) {
    const bool all = std::count(verdicts.begin(), verdicts.end(), Verdict::TooSlow) ==
                     std::ptrdiff_t(verdicts.size());
    const bool any =
        std::find(verdicts.begin(), verdicts.end(), Verdict::TooSlow) != verdicts.end();
    return all ? "too slow to tell" : any ? "none, or too slow" : "none";
  }
  if (length == values.size()) return "all";
  const std::size_t next = from + length;
  const std::string then =
      next < verdicts.size() && verdicts[next] == Verdict::TooSlow ? ", then too slow" : "";
  const std::string first = tic(values[from]), last = tic(values[from + length - 1]);
  if (length == 1) return "only " + first + then;
  if (from == 0) return "to " + last + then;
  if (next == values.size()) return "from " + first;
  return first + " to " + last + then;
}

void writeMapPage(const fs::path& out, const std::string& command,
                  const std::vector<SweepGroup>& groups, const MapPlan& plan, int missing) {
  Overview overview(plan.methods, "what is made harder");
  std::string body, trouble;
  for (const SweepGroup& group : groups) {
    const MapPlan own = planFor(group, plan);
    const std::vector<Reading> readings = readGroup(out, group, own);
    if (readings.empty()) continue;
    const Section section =
        group.second.empty() ? sweepSection(readings, overview) : pairSection(group, readings, own);
    addFault(trouble, drawStrips(group.title, section.panels, out / "stability", group.name));
    body += "## " + group.title + "\n\n" + section.before +
            picture("stability", group.name, group.title + ": what holds up to where") +
            section.after;
  }
  std::string page = "# Stiff and extreme: what holds up to where\n\n    " + command + "\n\n" +
                     describeMachine() + '\n' + legend;
  if (missing > 0)
    page += "**Not complete**: " + std::to_string(missing) +
            " sweeps are missing; the same command with `--resume` goes on.\n\n";
  delassus::writeFile(
      out / "stability.md",
      page + "## At a glance\n\nThe longest run of values over which the law holds.\n\n" +
          overview.text() + trouble + body);
}

}  // namespace demos::report::stability
