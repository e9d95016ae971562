#include "core/bench/paper/experiments.h"

#include <fmt/format.h>

#include "core/bench/machine.h"

namespace noonmark::bench {

namespace {

Finding makeFailedFinding(const char* title, const Error& error) {
    return {.title = title, .text = "This experiment failed: " + error.text(), .comparisons = {}};
}

std::string describeSite(const BenchSite& site) {
    return fmt::format("{}, {} buildings; {} and its year, {}", site.name, site.city.buildings.size(),
                       noonmark::formatText(site.date), site.zone);
}

}  // namespace

void Experiments::add(const char* title, const Make& make, double share) {
    if (work_.stopped()) return;
    shares_ += share;
    const Stopwatch watch;
    Result<Finding> finding =
        make({work_.progress, work_.stop, Allowance(shares_ * budgetS_ - watch_.seconds())});
    if (!finding && isCancelled(finding.error())) return;
    if (!finding) finding = makeFailedFinding(title, finding.error());
    finding->seconds = watch.seconds();
    findings_.push_back(std::move(*finding));
}

void Experiments::remark(const std::string& text) {
    if (!findings_.empty()) findings_.front().remarks.push_back(text);
}

Result<BenchReport> Experiments::into(BenchReport report, const BenchSite& site, const Extent& extent) && {
    if (work_.stopped()) return cancelled();
    report.site = describeSite(site);
    report.machine = describeMachine(detectMachine());
    report.extent = extent.words;
    for (const Finding& finding : findings_) report.seconds += finding.seconds;
    report.findings = std::move(findings_);
    fillSummary(report);
    return report;
}

Result<void> check(const BenchSite& site) {
    if (site.city.buildings.empty())
        return failure("There are no buildings to measure", site.name, "Choose a city with buildings");
    // Reports a wrong date or zone once, instead of in every experiment.
    return makeNoonHour(site).map([](const SunSteps&) {});
}

}  // namespace noonmark::bench
