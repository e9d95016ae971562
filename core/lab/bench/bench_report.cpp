#include "core/lab/bench/bench_report.h"

#include <fmt/format.h>
#include <malloc.h>
#include <tbb/info.h>
#include <algorithm>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "core/base/csv_text.h"
#include "core/lab/bench/contests/moments.h"
#include "core/lab/bench/finding.h"

namespace noonmark::bench {

namespace {

void addCell(CsvText& csv, const TableCell& cell) {
    if (const auto* number = std::get_if<double>(&cell))
        csv.number(*number);
    else if (const auto* text = std::get_if<std::string>(&cell))
        csv.text(*text);
    else
        csv.nothing();
}

// A line of /proc/self/status, in kB: "VmHWM:	  123456 kB".
std::optional<std::uint64_t> statusBytes(const std::string& name) {
    std::ifstream file("/proc/self/status");
    for (std::string line; std::getline(file, line);)
        if (line.starts_with(name + ":")) return 1024 * std::stoull(line.substr(name.size() + 1));
    return {};
}

// Writing 5 resets the peak to the current memory (proc(5), clear_refs).
bool resetPeak() {
    std::ofstream file("/proc/self/clear_refs");
    file << "5" << std::flush;
    return bool(file);
}

}  // namespace

std::string toCsv(const Table& table) {
    CsvText csv({table.columns.begin(), table.columns.end()});
    for (const auto& row : table.rows) {
        for (const TableCell& cell : row) addCell(csv, cell);
        csv.endRow();
    }
    return csv.take();
}

std::optional<std::uint64_t> measurePeakMemory(const std::function<void()>& work) {
    malloc_trim(0);
    if (!resetPeak()) return {};
    const auto before = statusBytes("VmRSS");
    work();
    const auto peak = statusBytes("VmHWM");
    if (!before || !peak) return {};
    return *peak > *before ? *peak - *before : 0;
}

namespace {

// Linux lists its processors in this file, as "model name : AMD EPYC 9B14".
std::string processorName() {
    std::ifstream file("/proc/cpuinfo");
    for (std::string line; std::getline(file, line);)
        if (line.starts_with("model name"))
            if (const auto begin = line.find_first_not_of(" \t:", line.find(':')); begin != std::string::npos)
                return line.substr(begin);
    return "unknown processor";
}

}  // namespace

Machine detectMachine() { return {processorName(), tbb::info::default_concurrency()}; }

std::string describeMachine(const Machine& machine) {
    return fmt::format("{}, {} thread{}", machine.processor, machine.threads,
                       machine.threads == 1 ? "" : "s");
}

void fillSummary(BenchReport& report) {
    for (SummaryFigure& figure : report.summary)
        for (const Finding& finding : report.findings)
            if (const auto found = finding.summary.find(figure.key); found != finding.summary.end())
                figure.value = found->second;
}

namespace {

bool misses(const SummaryFigure& figure) {
    constexpr double allowance = 1.25;
    if (!figure.target) return false;
    if (!figure.value) return true;
    const double wanted = figure.target->value;
    return figure.target->isMinimum ? *figure.value * allowance < wanted : *figure.value > wanted * allowance;
}

}  // namespace

SummaryFigure targetFigure(std::string key, std::string what, Target target) {
    return {std::move(key),
            std::move(what),
            fmt::format("{} {:g}", target.isMinimum ? ">=" : "<=", target.value),
            {},
            target};
}

std::vector<SummaryFigure> listMissed(const BenchReport& report) {
    std::vector<SummaryFigure> missed;
    std::ranges::copy_if(report.summary, std::back_inserter(missed), misses);
    return missed;
}

std::string summaryJson(const BenchReport& report) {
    nlohmann::ordered_json json;
    for (const SummaryFigure& figure : report.summary)
        json[figure.key] = figure.value ? nlohmann::ordered_json(*figure.value) : nlohmann::ordered_json();
    return json.dump(2) + '\n';
}

Comparison summaryTable(const BenchReport& report) {
    Comparison table{{"", "ours", report.reference}, {}};
    for (const SummaryFigure& figure : report.summary)
        table.rows.push_back(
            {figure.what, figure.value ? formatThreeDigits(*figure.value) : "not measured", figure.paper});
    return table;
}

}  // namespace noonmark::bench
