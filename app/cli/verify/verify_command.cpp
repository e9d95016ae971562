#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <ostream>
#include <set>
#include <sstream>

#include "app/cli/base/command.h"
#include "app/cli/base/interrupt.h"
#include "app/cli/base/offscreen_qt.h"
#include "app/cli/verify/later_save.h"
#include "app/cli/verify/repeat_run.h"
#include "app/cli/verify/verification.h"
#include "app/questions/question.h"
#include "app/report/files/read_report.h"
#include "core/base/version.h"
#include "core/io/files/plain_file.h"
#include "core/study/text/region_text.h"
#include "core/study/text/warnings_json.h"

namespace noonmark::cli {

namespace {

namespace fs = std::filesystem;

struct VerifyOptions {
    std::string report;
    std::string inputs;
    bool json = false;
};

// How answers are filed; several questions may share a command.
std::vector<FiledForm> listFiledForms() {
    std::vector<FiledForm> forms;
    for (const Question* question : allQuestions())
        if (question->filed) forms.push_back(*question->filed);
    return forms;
}

std::vector<std::string_view> listOnce(std::string_view FiledForm::*member) {
    std::vector<std::string_view> values;
    for (const FiledForm& form : listFiledForms())
        if (std::ranges::find(values, form.*member) == values.end()) values.push_back(form.*member);
    return values;
}

Result<std::string> readTable(const fs::path& file) {
    if (auto plain = checkPlainFile(file); !plain) return tl::make_unexpected(plain.error());
    std::error_code ignored;
    if (fs::file_size(file, ignored) > maxBytesOfRecord)
        return limitReached("The table is larger than any that a report has", file.string(), {});
    std::ifstream stream(file, std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(stream), {});
}

// A record that was renamed is recognised by the command that made it.
fs::path recordNameOf(const ResultRecord& record) {
    const auto forms = listFiledForms();
    return std::ranges::find(forms, record.command[1], &FiledForm::command)->record;
}

// The report of the filed one's kind that the command wrote; empty: none.
fs::path findComputedReport(const ResultRecord& record, const FiledReport& filed, const fs::path& computed) {
    std::error_code ignored;
    for (const FiledForm& form : listFiledForms())
        if (form.command == record.command[1] && form.isBook == filed.isBook && !form.report.empty() &&
            fs::is_regular_file(computed / form.report, ignored))
            return computed / form.report;
    return {};
}

Result<nlohmann::ordered_json> readComputed(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    auto json = nlohmann::ordered_json::parse(stream, nullptr, false);
    if (json.is_discarded()) return failure("The repeated run wrote no record", file.string(), {});
    return json;
}

// region.geojson is written beside a report whose command names it; it states no hash, but the figures do.
Result<void> addRegionFile(const RepeatFolder& folder, const VerifyOptions& options) {
    for (const fs::path& place : {fs::path(options.report).parent_path(), fs::path(options.inputs)})
        if (std::error_code error; fs::exists(place / regionFileName, error))
            return folder.add(place / regionFileName);
    return {};
}

// Tables that both the report's folder and the new one hold are compared; of the other files only their names
// are known to be the same.
Result<void> compareFilesBeside(const fs::path& report, const fs::path& computed,
                                Verification& verification) {
    const fs::path beside = report.parent_path();
    std::set<fs::path> names;
    std::error_code ignored;
    for (const auto& entry : fs::directory_iterator(computed, ignored)) names.insert(entry.path().filename());
    for (const fs::path& name : names) {
        const bool isFiled = name == report.filename(), isThere = fs::is_regular_file(beside / name, ignored);
        if (isFiled || !isThere) continue;
        if (name.extension() != ".csv") {
            verification.notCompared.push_back(name.string());
            continue;
        }
        const auto filed = readTable(beside / name), fresh = readTable(computed / name);
        if (!filed) return tl::make_unexpected(filed.error());
        if (!fresh) return tl::make_unexpected(fresh.error());
        verification.tables.push_back(compareTables(name.string(), *filed, *fresh));
    }
    return {};
}

/// The project that was saved again since; null without one.
const FoundFile* findLaterSave(const Verification& verification) {
    const auto found = std::ranges::find_if(verification.files, &FoundFile::isSavedAgain);
    return found == verification.files.end() ? nullptr : &*found;
}

/// Takes out the differences that only state the hash of the project's file, which is another one.
void leaveOutFileHash(Verification& verification, const std::string& recorded) {
    std::erase_if(verification.figures->differences,
                  [](const RecordDifference& one) { return one.key == "project.file_sha256"; });
    if (!verification.printed) return;
    std::erase_if(verification.printed->differences, [&](const WordDifference& one) {
        std::string words = one.recorded;  // a hash may be broken into lines
        std::erase(words, ' ');
        return words == recorded;
    });
}

Result<void> comparePrinted(const FiledReport& filed, const fs::path& computed, Verification& verification) {
    const auto printed = readPrintedWords(computed);
    if (!printed) return tl::make_unexpected(printed.error());
    verification.printed = compareWords(filed.printed, *printed);
    if (!verification.sameProgram || findLaterSave(verification) != nullptr) {
        verification.notCompared.emplace_back(
            verification.sameProgram ? "how the pages look, since they print the hash of the project's file"
                                     : "how the pages look, since another version made them");
        return {};
    }
    const Interrupt interrupt;
    return comparePages(verification.report, computed, interrupt.token()).map([&](PageComparison pages) {
        verification.pages = std::move(pages);
    });
}

Result<void> repeat(const VerifyOptions& options, const ResultRecord& record, const FiledReport& filed,
                    const Console& console, Verification& verification) {
    const auto folder = RepeatFolder::make(verification.files);
    if (!folder) return tl::make_unexpected(folder.error());
    if (auto added = addRegionFile(*folder, options); !added) return added;
    if (auto ran = folder->run(record.command, console); !ran) return ran;
    const auto computed = readComputed(folder->outputs() / recordNameOf(record));
    if (!computed) return tl::make_unexpected(computed.error());
    verification.figures = compareRecords(record.json, *computed);
    if (auto compared = compareFilesBeside(options.report, folder->outputs(), verification); !compared)
        return compared;
    if (filed.isRecord) return {};
    // Of most questions the command writes a page, and a book of sheets only on request.
    if (const fs::path report = findComputedReport(record, filed, folder->outputs()); !report.empty())
        return comparePrinted(filed, report, verification);
    verification.notCompared.emplace_back("what the pages print, and how they look");
    return {};
}

Result<Verification> verify(const VerifyOptions& options, const Console& console) {
    const auto filed = readReport(options.report, listOnce(&FiledForm::record));
    if (!filed) return tl::make_unexpected(filed.error());
    const auto record = parseResultRecord(filed->record, listOnce(&FiledForm::command), options.report);
    if (!record) return tl::make_unexpected(record.error());
    Verification verification{.report = options.report,
                              .recordName = filed->recordName,
                              .program = record->json.value("program", std::string("an unknown program")),
                              .files = {},
                              .figures = {},
                              .printed = {},
                              .pages = {},
                              .tables = {},
                              .notCompared = {}};
    verification.sameProgram = verification.program == "Noonmark " + std::string(version());
    {
        const Interrupt interrupt;
        verification.files = findInputs(record->files, options.inputs, interrupt.token());
        if (interrupt.token().stop_requested()) return cancelled();
        acceptLaterSaves(verification.files, record->json);
    }
    if (!areComplete(verification.files)) return verification;
    if (auto repeated = repeat(options, *record, *filed, console, verification); !repeated)
        return tl::make_unexpected(repeated.error());
    if (const FoundFile* saved = findLaterSave(verification))
        leaveOutFileHash(verification, saved->recorded.sha256);
    return verification;
}

int runVerify(VerifyOptions options, const Console& console) {
    const OffscreenQt qt;
    options.report = fs::absolute(options.report).lexically_normal().string();
    if (options.inputs.empty()) options.inputs = fs::path(options.report).parent_path().string();
    options.inputs = fs::absolute(options.inputs).lexically_normal().string();
    const auto verification = verify(options, console);
    if (!verification) return fail(console, verification.error(), exitUsage);
    if (options.json)
        console.out << toJsonText(verificationJson(*verification)) << '\n';
    else
        console.out << describe(*verification);
    switch (verification->verdict()) {
        case Verdict::agrees:
            return exitOk;
        case Verdict::differs:
            return exitFailed;
        case Verdict::notComputed:
            return exitUsage;
    }
    return exitFailed;
}

}  // namespace

void addVerifyCommand(CLI::App& app, Run& run) {
    const auto options = std::make_shared<VerifyOptions>();
    CLI::App* command = app.add_subcommand(
        "verify", "Check a filed report: are its inputs the same, and does computing it again agree?");
    command
        ->add_option("report", options->report,
                     "The report (PDF), or the record beside it, such as study.json or places.json")
        ->required()
        ->type_name("FILE");
    command
        ->add_option("--inputs", options->inputs,
                     "Folder with the project or city files that the report names (default: the report's)")
        ->type_name("DIR");
    addJsonFlag(*command, options->json);
    command->footer(
        "Computes the result again in a folder of its own; nothing is written elsewhere. Compares the "
        "record, "
        "what the pages print and how they look, and the tables beside the report, and says what it does not "
        "compare. The exit code is 0 if all agrees, 1 if something differs, and 2 if nothing could be "
        "computed.");
    command->callback([options, &run] {
        run = [options](const Console& console) { return runVerify(*options, console); };
    });
}

}  // namespace noonmark::cli
