#include <fmt/format.h>
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <ostream>
#include <ranges>
#include <set>
#include <sstream>
#include <string>
#include <system_error>
#include <vector>

#include "app/cli/base/command.h"
#include "app/cli/base/command_line.h"
#include "app/cli/base/interrupt.h"
#include "app/cli/base/offscreen_qt.h"
#include "app/cli/verify/verification.h"
#include "app/questions/question.h"
#include "app/report/files/read_report.h"
#include "app/report/scenarios/scenario_study.h"
#include "core/base/csv_text.h"
#include "core/base/result.h"
#include "core/base/version.h"
#include "core/base/working_files.h"
#include "core/io/files/plain_file.h"
#include "core/receivers/place_names.h"
#include "core/study/text/error_text.h"
#include "core/study/text/region_text.h"
#include "core/study/verification/result_record.h"
#include "scenarios/project/project_provenance.h"

namespace noonmark::cli {

namespace {

std::string textAt(const nlohmann::ordered_json& json, const char* key) {
    const auto found = json.find(key);
    return found != json.end() && found->is_string() ? found->get<std::string>() : std::string();
}

/// What of the project the record is about. Error: it has no such weight table.
Result<MeasuredPart> partOf(const Project& project, const nlohmann::ordered_json& record) {
    MeasuredPart part{textAt(record, "scenario"), textAt(record, "baseline"), {}, {}};
    const std::string weights = textAt(record, "weights");
    if (weights.empty()) return part;
    return findWeights(project, weights).map([&](TimeWeights table) {
        part.weights = std::move(table);
        return part;
    });
}

// Of a record of sun by place: whether the project has all of its places, with their kinds. Regions may be
// those of the command.
bool hasPlaces(const Project& project, const nlohmann::ordered_json& record) {
    const auto places = record.find("places");
    if (!record.contains("enough_hours") || places == record.end() || !places->is_array()) return true;
    std::set<std::pair<std::string, std::string>> known;
    for (const Place& place : project.places) known.emplace(place.name, nameOf(place.kind));
    return std::ranges::all_of(*places, [&](const auto& place) {
        if (!place.is_object()) return false;
        const std::pair listed{textAt(place, "name"), textAt(place, "kind")};
        return listed.second == nameOf(PlaceKind::other) || known.contains(listed);
    });
}

bool holdsContent(const std::filesystem::path& file, const nlohmann::ordered_json& record,
                  const std::string& contentSha256) {
    const auto disk = ProjectFile::open(file);
    if (!disk || !hasPlaces(disk->project(), record)) return false;
    const auto part = partOf(disk->project(), record);
    if (!part) return false;
    const auto content = hashContent(disk->project(), *part);
    return content && *content == contentSha256;
}

/// A record, or the part of it that is about one scenario, that names a saved project.
struct ProjectPart {
    nlohmann::ordered_json record;  ///< with the scenario, the baseline and the weights, where it has some
    std::string fileSha256;
    std::string contentSha256;
};

void addProjectPart(std::vector<ProjectPart>& parts, const nlohmann::ordered_json& record,
                    const std::string& weights = {}) {
    const auto project = record.find("project");
    if (project == record.end() || !project->is_object()) return;
    ProjectPart part{record, textAt(*project, "file_sha256"), textAt(*project, "content_sha256")};
    if (!weights.empty()) part.record["weights"] = weights;
    if (!part.fileSha256.empty() && !part.contentSha256.empty()) parts.push_back(std::move(part));
}

/// Scenarios that were measured side by side each have a project of their own in the record.
std::vector<ProjectPart> listProjectParts(const nlohmann::ordered_json& record) {
    std::vector<ProjectPart> parts;
    addProjectPart(parts, record);
    const auto scenarios = record.find("scenarios");
    if (scenarios == record.end() || !scenarios->is_array()) return parts;
    for (const auto& one : *scenarios) {
        if (!one.is_object()) continue;
        const auto score = one.find("score");
        const bool isScored = score != one.end() && score->is_object();
        addProjectPart(parts, one, isScored ? textAt(*score, "weights") : std::string());
    }
    return parts;
}

/// Accepts a project that was saved again since the result, where all that the result rests on is as
/// recorded: city, edits of scenarios and baseline, weights (hashContent()), names and kinds of places. Its
/// file has another hash.
/// Projects that cannot be read stay as they were found.
void acceptLaterSaves(std::vector<FoundFile>& files, const nlohmann::ordered_json& record) {
    const std::vector<ProjectPart> parts = listProjectParts(record);
    for (FoundFile& file : files) {
        const auto isOfFile = [&](const ProjectPart& part) {
            return part.fileSha256 == file.recorded.sha256;
        };
        if (file.agrees || !file.path || std::ranges::none_of(parts, isOfFile)) continue;
        file.isSavedAgain = file.agrees = std::ranges::all_of(parts, [&](const ProjectPart& part) {
            return !isOfFile(part) || holdsContent(*file.path, part.record, part.contentSha256);
        });
    }
}

/// A folder in which a recorded command runs: it holds only the files that the record names, under their
/// recorded names, and what the command writes. Removed at the end.
class RepeatFolder {
public:
    /// Error: the folder cannot be made, or two recorded files have the same name.
    static Result<RepeatFolder> make(const std::vector<FoundFile>& files);
    /// Adds a file under its own name. Files that are there already stay.
    [[nodiscard]] Result<void> add(const std::filesystem::path& file) const;
    /// Runs the words of a noonmark-cli command in the folder. Error: it failed, with what it said, or
    /// cancelled().
    [[nodiscard]] Result<void> run(const std::vector<std::string>& words, const Console& console) const;
    [[nodiscard]] std::filesystem::path outputs() const { return folder_.path() / "repeated"; }

private:
    explicit RepeatFolder(PrivateFolder folder) : folder_(std::move(folder)) {}
    PrivateFolder folder_;
};

namespace fs = std::filesystem;

/// Changes the working folder for its lifetime: the recorded command names files without their folders.
class WorkingFolder {
public:
    explicit WorkingFolder(const fs::path& folder) : before_(fs::current_path()) { fs::current_path(folder); }
    ~WorkingFolder() {
        std::error_code ignored;
        fs::current_path(before_, ignored);
    }
    WorkingFolder(const WorkingFolder&) = delete;
    WorkingFolder& operator=(const WorkingFolder&) = delete;

private:
    fs::path before_;
};

std::string nameOf(const RecordedFile& file) { return file.path.substr(file.path.find_last_of("/\\") + 1); }

// A link where the system permits it; files of a city may have gigabytes.
Result<void> place(const fs::path& file, const fs::path& at) {
    std::error_code error;
    fs::create_symlink(fs::absolute(file), at, error);
    if (error) fs::copy_file(file, at, error);
    if (error) return failure("The file cannot be placed beside the others", file.string(), error.message());
    return {};
}

Result<RepeatFolder> RepeatFolder::make(const std::vector<FoundFile>& files) {
    std::error_code error;
    const fs::path temporary = fs::temp_directory_path(error);
    RepeatFolder folder{PrivateFolder(temporary)};
    const fs::path& path = folder.folder_.path();
    if (error || path.empty())
        return failure("The folder for the repeated run cannot be made", temporary.string(),
                       "Check the folder for temporary files (TMPDIR)");
    for (const FoundFile& file : files) {
        if (!file.path) continue;
        const fs::path at = path / nameOf(file.recorded);
        if (fs::exists(at))
            return failure("Two recorded files have the same name", nameOf(file.recorded),
                           "Run the recorded command by hand with paths that distinguish them");
        if (auto placed = place(*file.path, at); !placed) return tl::make_unexpected(placed.error());
    }
    return folder;
}

Result<void> RepeatFolder::add(const fs::path& file) const {
    const fs::path at = folder_.path() / file.filename();
    return fs::exists(at) ? Result<void>() : place(file, at);
}

Result<void> RepeatFolder::run(const std::vector<std::string>& words, const Console& console) const {
    std::vector<const char*> argv;
    argv.reserve(words.size());
    for (const std::string& word : words) argv.push_back(word.c_str());
    std::ostringstream out, err;
    const WorkingFolder there(folder_.path());
    const int code = runCommandLine(int(argv.size()), argv.data(),
                                    {out, console.watched ? console.err : err, console.watched});
    if (code == exitCancelled) return cancelled();
    if (code == exitOk) return {};
    return failure(fmt::format("The recorded command fails: {}", err.str()), "repeat",
                   "The record may come from another version of Noonmark");
}

struct VerifyOptions {
    std::string report;
    std::string inputs;
    bool json = false;
};

// How answers are filed; several questions may share a command. Scenarios side by side are studies, and no
// question of their own.
std::vector<FiledForm> listFiledForms() {
    std::vector<FiledForm> forms{{"scenarios", "scenarios.json", "scenarios.pdf", true}};
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
        if (std::error_code error; !place.empty() && fs::exists(place / regionFileName, error))
            return folder.add(place / regionFileName);
    return {};
}

// Verdicts that the window counted beside the scenarios: the review has a record of its own.
std::vector<std::string> columnsLeftOut(const fs::path& name, const std::string& filed,
                                        Verification& verification) {
    if (name != "scenarios.csv") return {};
    std::vector<std::string> columns = verdictColumns();
    const auto rows = parseCsvRows(filed);
    const auto& heading = rows.empty() ? std::vector<std::string>() : rows.front().fields;
    const auto rule = std::ranges::find(heading, columns.front()) - heading.begin();
    if (std::ranges::any_of(rows | std::views::drop(1), [&](const CsvRow& row) {
            return std::size_t(rule) < row.fields.size() && !row.fields[std::size_t(rule)].empty();
        }))
        verification.notCompared.emplace_back("verdicts in scenarios.csv and scenarios.json");
    return columns;
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
        verification.tables.push_back(
            compareTables(name.string(), *filed, *fresh, columnsLeftOut(name, *filed, verification)));
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
                  [](const RecordDifference& one) { return one.key.ends_with("project.file_sha256"); });
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

// Where no folder was given, also beside the report's folder: who gets a project's folder has its project
// there.
void lookForInputs(const VerifyOptions& options, const ResultRecord& record, const std::stop_token& stop,
                   Verification& verification) {
    const fs::path beside = fs::path(options.report).parent_path();
    const fs::path folder = options.inputs.empty() ? beside : fs::path(options.inputs);
    verification.files = findInputs(record.files, folder, stop);
    verification.lookedIn = {folder.string() + " and its subfolders"};
    if (options.inputs.empty() && beside.has_relative_path() && !areComplete(verification.files)) {
        findInputsBeside(verification.files, beside.parent_path());
        verification.lookedIn.push_back(beside.parent_path().string());
    }
    acceptLaterSaves(verification.files, record.json);
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
                              .lookedIn = {},
                              .figures = {},
                              .printed = {},
                              .pages = {},
                              .tables = {},
                              .notCompared = {}};
    verification.sameProgram = verification.program == "Noonmark " + std::string(version());
    {
        const Interrupt interrupt;
        lookForInputs(options, *record, interrupt.token(), verification);
        if (interrupt.token().stop_requested()) return cancelled();
    }
    if (!areComplete(verification.files)) return verification;
    if (auto repeated = repeat(options, *record, *filed, console, verification); !repeated)
        return tl::make_unexpected(repeated.error());
    if (const FoundFile* saved = findLaterSave(verification))
        leaveOutFileHash(verification, saved->recorded.sha256);
    return verification;
}

// Of a folder the page or else the record that lies in it; the folder itself where there is none.
fs::path reportIn(const fs::path& place) {
    std::error_code ignored;
    if (!fs::is_directory(place, ignored)) return place;
    for (const FiledForm& form : listFiledForms())
        for (const std::string_view name : {form.report, form.record})
            if (!name.empty() && fs::is_regular_file(place / name, ignored)) return place / name;
    return place;
}

int runVerify(VerifyOptions options, const Console& console) {
    const OffscreenQt qt;
    options.report = reportIn(fs::absolute(options.report).lexically_normal()).string();
    if (std::error_code ignored; fs::is_directory(options.report, ignored))
        return fail(console,
                    Error{"The folder holds no report or record of Noonmark's", options.report,
                          "Give the file: study.json, places.json, a PDF"},
                    exitUsage);
    if (!options.inputs.empty()) options.inputs = fs::absolute(options.inputs).lexically_normal().string();
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
        ->add_option(
            "--inputs", options->inputs,
            "Folder with the project or city files that the report names (default: the report's, and for "
            "what is not there the one around it)")
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
