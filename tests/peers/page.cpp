#include "tests/peers/page.h"

#include "demos/report/markdown.h"
#include "demos/table.h"
#include "tests/peers/measured.h"

namespace delassus::peers {

namespace {

using demos::shortNumber;

/// Two digits, never as a power.
std::string shortRatio(double value) { return demos::report::shortMs(value); }

std::string milliseconds(double seconds) { return demos::report::shortMs(1000 * seconds); }

double ratio(const Comparison& comparison) { return *comparison.ours / comparison.best->seconds; }

std::string bold(const std::string& words) { return "**" + words + "**"; }

}  // namespace

std::string prefaceOfFiles() {
  return R"(# Problem files, beside the solvers of others

    bash .ci/setup.sh peers && cmake --preset peers && cmake --build --preset peers
    taskset -c 1 build-peers/tests/peers/delassus_peers --out renders/report/peers.md

Frictional contact problems of other people's simulators, with W as entries: `delassus solve` and the seven general solvers of
Siconos 4.4 (NSGS, NSN_AC, NSN_FB, ADMM, PROX, FPP, VI_EG), cold and in turn, each with the tolerance of its own, and the
peers in the storage of W, that make it fastest. Milliseconds of one processor: quote the ratios.

)";
}

std::string prefaceOfPiles() {
  return R"(# Piles of light and heavy boxes, beside the solvers of others

    bash .ci/setup.sh peers && cmake --preset peers && cmake --build --preset peers
    taskset -c 1 build-peers/tests/peers/delassus_peers --piles --out renders/report/piles.md

Square pyramids of boxes, every other layer a thousand or a million times as heavy, friction 0.4 or 1, all boxes moving and turning
at up to 0.3 m/s and rad/s on top of what gravity adds in a step of 1/60 s: a step of an earthquake, from no reactions.
`delassus::solve` with W over the bodies, as in worlds, and the seven general solvers of Siconos 4.4 (NSGS, NSN_AC, NSN_FB,
ADMM, PROX, FPP, VI_EG) on the entries of W; all else as in [the page of problem files](peers.md). Solved is what `delassus solve`
calls so: rel and vel (its help has both measures) at 1e-8. Of what is not solved in time, in brackets, the least that was left
of the larger of them in any try; `no answer`: no try came to an end.

With a friction of 1 answers may repel what comes near them. Linearised, steps of the walk from region to region lead away from
three of thirty answers for the pyramids of 14 boxes at 1 : 1e3, with a friction of 0.4 from none
(`MassRatio.WithMuchFrictionAnswersMayRepel` among the tests has the formula); these three are among the four that take the most
regions. That is a part of what makes such piles hard, not all: of nine pyramids of 30 boxes that are lost from no reactions and
solved from the answers for less friction, the answers of five repel.

)";
}

std::string tableHeading(int peers) {
  return "| problem | contacts | delassus, ms | best peer, ms | delassus / peer | of " +
         std::to_string(peers) + " peers reach it |\n|---|--:|--:|--:|--:|--:|\n";
}

std::string tableRow(const Comparison& comparison) {
  const auto& [problem, contacts, ours, best, peersThatReach, leftByUs, leftByPeers] = comparison;
  const auto unsolved = [](double left) {
    return left < infinity ? "not solved (" + shortNumber(left) + ")" : std::string("no answer");
  };
  const std::string peer =
      best ? milliseconds(best->seconds) + " (" + best->name + ")" : unsolved(leftByPeers);
  const std::string ratioWord = ours && best ? shortRatio(ratio(comparison)) : ours ? "alone" : "–";
  return "| " + problem + " | " + std::to_string(contacts) + " | " +
         (ours ? milliseconds(*ours) : unsolved(leftByUs)) + " | " + peer + " | " +
         (comparison.faster() ? bold(ratioWord) : ratioWord) + " | " +
         std::to_string(peersThatReach) + " |\n";
}

std::string summary(const std::vector<Comparison>& comparisons, const Conditions& conditions) {
  int solved = 0, faster = 0;
  std::vector<double> ratios;
  for (const Comparison& comparison : comparisons) {
    solved += comparison.ours ? 1 : 0;
    faster += comparison.faster() ? 1 : 0;
    if (comparison.ours && comparison.best) ratios.push_back(ratio(comparison));
  }
  const std::string medianRatio = ratios.empty() ? "–" : shortRatio(median(ratios));
  return "Of " + std::to_string(comparisons.size()) + " problems, to " +
         shortNumber(conditions.tolerance) + " in both rel and vel, " +
         shortNumber(conditions.secondsLimit) + " s a solve at most: delassus solves " +
         std::to_string(solved) + " and is faster than the best peer, or alone, on " +
         std::to_string(faster) + "; median ratio " + medianRatio + ".\n";
}

}  // namespace delassus::peers
