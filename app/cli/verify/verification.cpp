#include "app/cli/verify/verification.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "app/cli/table.h"

namespace noonmark::cli {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t mostDifferences = 20;

bool printsOtherFigures(const WordComparison& printed) {
    return std::ranges::any_of(printed.differences, &WordDifference::hasFigure);
}

std::string_view nameOf(Verdict verdict) {
    switch (verdict) {
        case Verdict::agrees:
            return "agrees";
        case Verdict::differs:
            return "differs";
        case Verdict::notComputed:
            return "not computed";
    }
    return {};
}

std::string_view stateOf(const FoundFile& file) {
    if (file.recorded.sha256.empty() && file.agrees) return "a sample, made by the program";
    if (file.agrees) return "the same file";
    if (file.path)
        return file.recorded.needed ? "ANOTHER FILE: its hash differs" : "another file, not needed";
    return file.recorded.needed ? "NOT FOUND" : "not found, not needed";
}

std::string orNothing(const std::string& text) { return text.empty() ? "nothing" : text; }

std::string describeFiles(const Verification& verification) {
    std::string text = "Inputs\n";
    for (const FoundFile& file : verification.files)
        text += fmt::format("  {}: {}\n", file.recorded.path, stateOf(file));
    return text;
}

std::string describeFigures(const RecordComparison& figures) {
    std::string text = fmt::format("\nFigures and texts of the record: {} compared, {} differ\n",
                                   withCommas(figures.compared), withCommas(figures.differences.size()));
    for (std::size_t i = 0; i < std::min(figures.differences.size(), mostDifferences); ++i) {
        const RecordDifference& one = figures.differences[i];
        text += fmt::format("  {}: recorded {}, computed {}\n", one.key, orNothing(one.recorded),
                            orNothing(one.computed));
    }
    return text;
}

std::string describePrinted(const WordComparison& printed) {
    std::string text;
    std::size_t different = 0;
    for (const WordDifference& one : printed.differences) {
        if (!one.hasFigure || ++different > mostDifferences) continue;
        text += fmt::format("  ... {} [{}], computed [{}]\n", one.before, one.recorded, one.computed);
    }
    return fmt::format("\nFigures printed on the pages: {}; passages with other figures: {}\n",
                       withCommas(printed.figures), withCommas(different)) +
           text;
}

Json filesJson(const std::vector<FoundFile>& files) {
    Json json = Json::array();
    for (const FoundFile& file : files)
        json.push_back({{"path", file.recorded.path},
                        {"sha256", file.recorded.sha256.empty() ? Json() : Json(file.recorded.sha256)},
                        {"needed", file.recorded.needed},
                        {"found", file.path ? Json(file.path->string()) : Json()},
                        {"agrees", file.agrees}});
    return json;
}

Json figuresJson(const RecordComparison& figures) {
    Json differences = Json::array();
    for (const RecordDifference& one : figures.differences)
        differences.push_back({{"key", one.key}, {"recorded", one.recorded}, {"computed", one.computed}});
    return {{"compared", figures.compared}, {"differences", differences}};
}

Json printedJson(const WordComparison& printed) {
    Json differences = Json::array();
    for (const WordDifference& one : printed.differences)
        differences.push_back({{"before", one.before},
                               {"recorded", one.recorded},
                               {"computed", one.computed},
                               {"has_figure", one.hasFigure}});
    return {{"figures", printed.figures}, {"differences", differences}};
}

}  // namespace

Verdict Verification::verdict() const {
    if (!figures) return Verdict::notComputed;
    const bool same = figures->differences.empty() && (!printed || !printsOtherFigures(*printed));
    return same ? Verdict::agrees : Verdict::differs;
}

Json verificationJson(const Verification& verification) {
    return {{"report", verification.report},
            {"record", verification.recordName},
            {"program", verification.program},
            {"verdict", nameOf(verification.verdict())},
            {"inputs", filesJson(verification.files)},
            {"figures", verification.figures ? figuresJson(*verification.figures) : Json()},
            {"printed", verification.printed ? printedJson(*verification.printed) : Json()}};
}

std::string describe(const Verification& verification) {
    std::string text = fmt::format("{} ({}, by {})\n\n", verification.report, verification.recordName,
                                   verification.program) +
                       describeFiles(verification);
    if (verification.figures) text += describeFigures(*verification.figures);
    if (verification.printed) text += describePrinted(*verification.printed);
    switch (verification.verdict()) {
        case Verdict::agrees:
            return text + "\nThe report agrees with its inputs, to the last printed digit.\n";
        case Verdict::differs:
            return text + "\nTHE REPORT DOES NOT AGREE with what its inputs give.\n";
        case Verdict::notComputed:
            return text + "\nNothing was computed: give the folder with the recorded files by --inputs.\n";
    }
    return text;
}

}  // namespace noonmark::cli
