#include "app/cli/verify/verification.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string_view>

#include "app/cli/base/terminal_text.h"
#include "core/base/safe_text.h"

namespace noonmark::cli {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t maxDifferences = 20;

// Another version may word a passage differently; its figures are the same.
bool counts(const WordDifference& one, bool sameProgram) { return sameProgram || one.hasFigure; }

bool printsOther(const Verification& verification) {
    return verification.printed &&
           std::ranges::any_of(verification.printed->differences, [&](const WordDifference& one) {
               return counts(one, verification.sameProgram);
           });
}

bool looksOther(const std::optional<PageComparison>& pages) {
    return pages && (!pages->different.empty() || !pages->onlyInOne.empty());
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
    if (file.isSavedAgain) return "saved again since; what the result rests on is the same";
    if (file.agrees) return "the same file";
    if (!file.recorded.needed) return "the project holds what was read from it";
    return file.path ? "ANOTHER FILE: its hash differs" : "NOT FOUND";
}

// Of a file that is not read again the name is enough: where it once lay helps nobody.
std::string nameToPrint(const FoundFile& file) {
    const std::string& path = file.recorded.path;
    return cleanText(file.recorded.needed || file.agrees ? path : path.substr(path.find_last_of("/\\") + 1));
}

std::string orNothing(const std::string& text) { return text.empty() ? "nothing" : text; }

std::string describeFiles(const Verification& verification) {
    std::string text = "Inputs\n";
    for (const FoundFile& file : verification.files)
        text += fmt::format("  {}: {}\n", nameToPrint(file), stateOf(file));
    if (!verification.lookedIn.empty())
        text +=
            fmt::format("Looked in {}\n", cleanText(fmt::to_string(fmt::join(verification.lookedIn, ", "))));
    return text;
}

std::string listDifferences(const std::vector<RecordDifference>& differences) {
    std::string text;
    for (std::size_t i = 0; i < std::min(differences.size(), maxDifferences); ++i) {
        const RecordDifference& one = differences[i];
        text += fmt::format("  {}: recorded {}, computed {}\n", cleanText(one.key),
                            cleanText(orNothing(one.recorded)), cleanText(orNothing(one.computed)));
    }
    return text;
}

std::string describeFigures(const RecordComparison& figures) {
    return fmt::format("\nFigures and texts of the record: {} compared, {} differ\n",
                       withCommas(figures.compared), withCommas(figures.differences.size())) +
           listDifferences(figures.differences);
}

std::string describePrinted(const WordComparison& printed, bool sameProgram) {
    std::string text;
    std::size_t different = 0;
    for (const WordDifference& one : printed.differences) {
        if (!counts(one, sameProgram) || ++different > maxDifferences) continue;
        text += fmt::format("  ... {} [{}], computed [{}]\n", one.before, one.recorded, one.computed);
    }
    return fmt::format("\nFigures printed on the pages: {}; passages with other {}: {}\n",
                       withCommas(printed.figures), sameProgram ? "words or figures" : "figures",
                       withCommas(different)) +
           text;
}

std::string describePages(const PageComparison& pages) {
    std::string text = fmt::format("\nPages drawn and compared: {}; look different: {}\n",
                                   withCommas(pages.pages), withCommas(pages.different.size()));
    if (!pages.different.empty())
        text += fmt::format(
            "  page {}: something may cover what is printed there, or the fonts are others. Look at it "
            "beside "
            "a new report\n",
            fmt::join(pages.different, ", "));
    if (!pages.onlyInOne.empty())
        text += fmt::format("  page {}: in one of the two only, or of another size\n",
                            fmt::join(pages.onlyInOne, ", "));
    return text;
}

std::string describeTables(const std::vector<TableComparison>& tables) {
    std::string text;
    for (const TableComparison& table : tables) {
        text += fmt::format("\nFields of {}: {} compared, {} differ\n", table.name, withCommas(table.fields),
                            withCommas(table.differences.size()));
        text += listDifferences(table.differences);
    }
    return text;
}

std::string describeNotCompared(const std::vector<std::string>& things) {
    return things.empty() ? std::string() : fmt::format("\nNot compared: {}\n", fmt::join(things, ", "));
}

Json filesJson(const std::vector<FoundFile>& files) {
    Json json = Json::array();
    for (const FoundFile& file : files)
        json.push_back({{"path", file.recorded.path},
                        {"sha256", file.recorded.sha256.empty() ? Json() : Json(file.recorded.sha256)},
                        {"needed", file.recorded.needed},
                        {"found", file.path ? Json(file.path->string()) : Json()},
                        {"agrees", file.agrees},
                        {"saved_again", file.isSavedAgain}});
    return json;
}

Json differencesJson(const std::vector<RecordDifference>& all) {
    Json differences = Json::array();
    for (const RecordDifference& one : all)
        differences.push_back({{"key", one.key}, {"recorded", one.recorded}, {"computed", one.computed}});
    return differences;
}

Json figuresJson(const RecordComparison& figures) {
    return {{"compared", figures.compared}, {"differences", differencesJson(figures.differences)}};
}

Json tablesJson(const std::vector<TableComparison>& tables) {
    Json json = Json::array();
    for (const TableComparison& table : tables)
        json.push_back({{"name", table.name},
                        {"compared", table.fields},
                        {"differences", differencesJson(table.differences)}});
    return json;
}

Json pagesJson(const PageComparison& pages) {
    return {{"compared", pages.pages}, {"different", pages.different}, {"only_in_one", pages.onlyInOne}};
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
    const bool tablesAgree =
        std::ranges::all_of(tables, [](const TableComparison& one) { return one.differences.empty(); });
    const bool same =
        figures->differences.empty() && tablesAgree && !printsOther(*this) && !looksOther(pages);
    return same ? Verdict::agrees : Verdict::differs;
}

Json verificationJson(const Verification& verification) {
    return {{"report", verification.report},
            {"record", verification.recordName},
            {"program", verification.program},
            {"verdict", nameOf(verification.verdict())},
            {"inputs", filesJson(verification.files)},
            {"looked_in", verification.lookedIn},
            {"figures", verification.figures ? figuresJson(*verification.figures) : Json()},
            {"printed", verification.printed ? printedJson(*verification.printed) : Json()},
            {"pages", verification.pages ? pagesJson(*verification.pages) : Json()},
            {"tables", tablesJson(verification.tables)},
            {"not_compared", verification.notCompared}};
}

std::string describe(const Verification& verification) {
    std::string text = fmt::format("{} ({}, by {})\n\n", verification.report, verification.recordName,
                                   cleanText(verification.program)) +
                       describeFiles(verification);
    if (verification.figures) text += describeFigures(*verification.figures);
    if (verification.printed) text += describePrinted(*verification.printed, verification.sameProgram);
    if (verification.pages) text += describePages(*verification.pages);
    text += describeTables(verification.tables) + describeNotCompared(verification.notCompared);
    switch (verification.verdict()) {
        case Verdict::agrees:
            return text + "\nWhat was compared agrees with the inputs, to the last printed digit.\n";
        case Verdict::differs:
            return text + "\nTHE REPORT DOES NOT AGREE with what its inputs give.\n";
        case Verdict::notComputed:
            return text + "\nNothing was computed: give the folder with the recorded files by --inputs.\n";
    }
    return text;
}

}  // namespace noonmark::cli
