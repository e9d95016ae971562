#include "app/input/all_engines.h"
#include "app/questions/saved_question.h"
#include "app/report/book/answer_books.h"
#include "app/report/files/element_files.h"
#include "app/report/files/study_files.h"
#include "core/describe/text.h"
#include "core/measures/shadow_figures.h"
#include "core/study/elements/element_map.h"
#include "core/study/elements/element_study.h"
#include "core/study/elements/element_tables.h"
#include "core/study/provenance/repeat_command.h"
#include "core/study/study_json.h"
#include "core/study/text/breakdown_text.h"
#include "core/study/text/region_text.h"
#include "scenarios/project/results/save_result.h"

namespace noonmark {

namespace {

std::vector<CommandOption> drawnByLegend(const AnswerFiles& how) {
    return listLegendOptions(how.legend, false);
}

/// The shadow over cells of one scenario.
class StudyAnswer final : public AnswerOf<Study> {
public:
    StudyAnswer(std::shared_ptr<const Study> study, std::string scenario,
                std::vector<ContributionTable> ofPlaces = {})
        : AnswerOf(std::move(study)), scenario_(std::move(scenario)), ofPlaces_(std::move(ofPlaces)) {}

    [[nodiscard]] const Question& question() const override { return studyQuestion(); }
    [[nodiscard]] const StudySettings* settings() const override { return &content().settings; }
    [[nodiscard]] MeasuredPart part() const override {
        return {scenario_, {}, content().settings.region, {}};
    }
    [[nodiscard]] const Warnings& warnings() const override { return content().warnings; }
    [[nodiscard]] double seconds() const override { return content().seconds.at("total"); }

    [[nodiscard]] std::shared_ptr<const Answer> updated(const Project&, const std::string& scenario,
                                                        const std::string&) const override {
        return scenario == scenario_ ? nullptr : std::make_shared<StudyAnswer>(shared(), scenario, ofPlaces_);
    }
    [[nodiscard]] std::shared_ptr<const Answer> stated(Provenance provenance) const override {
        auto study = std::make_shared<Study>(content());
        study->provenance = std::move(provenance);
        return std::make_shared<StudyAnswer>(std::move(study), scenario_, ofPlaces_);
    }
    [[nodiscard]] const std::vector<ContributionTable>& ofPlaces() const override { return ofPlaces_; }
    [[nodiscard]] std::shared_ptr<const Answer> withPlace(ContributionTable of) const override {
        return std::make_shared<StudyAnswer>(shared(), scenario_,
                                             withContributions(ofPlaces_, std::move(of)));
    }

    [[nodiscard]] AnswerPage page(const LegendChoice& shown) const override {
        return withMonths(
            makePage(content().field, content().statistics, nameOf(content().settings.region), shown),
            makeMonthBars(content()));
    }
    [[nodiscard]] Result<std::string> command() const override { return makeRepeatCommand(content()); }
    [[nodiscard]] std::vector<CommandOption> drawnOptions(const AnswerFiles& how) const override {
        return drawnByLegend(how);
    }
    [[nodiscard]] std::string json() const override {
        return withContributions(studyJson(content()), ofPlaces_);
    }
    [[nodiscard]] SavedResult toSave(const Project& project) const override {
        SavedResult result = makeSavedResult(project, scenario_, content());
        result.settings = withContributions(std::move(result.settings), ofPlaces_);
        return result;
    }
    [[nodiscard]] std::vector<std::string> fileNames(const AnswerFiles& how) const override {
        auto names = studyFileNames(content().settings, optionsOf(how));
        names.emplace_back(regionFileName);
        return names;
    }
    [[nodiscard]] Result<std::vector<std::filesystem::path>> write(const City&,
                                                                   const std::filesystem::path& folder,
                                                                   const AnswerFiles& how) const override {
        return writeStudyFiles(content(), folder, optionsOf(how));
    }
    [[nodiscard]] Result<std::shared_ptr<const Book>> layOut(const std::shared_ptr<const City>&,
                                                             const AnswerFiles& how) const override {
        return bundleBook(makeStudyBook(content(), bookOf(how)), shared());
    }

private:
    [[nodiscard]] StudyFileOptions optionsOf(const AnswerFiles& how) const {
        return {.cellsCsv = how.cells,
                .rules = how.rules,
                .pictureWidth = how.pictureWidth,
                .legend = how.legend,
                .book = how.sheets ? std::optional(bookOf(how)) : std::nullopt,
                .ofPlaces = ofPlaces_};
    }

    std::string scenario_;
    std::vector<ContributionTable> ofPlaces_;
};

Result<std::shared_ptr<const Answer>> computeStudy(const Asked& asked, Progress& progress,
                                                   const std::stop_token& stop) {
    auto study =
        runStudy(asked.loaded.read.city, asked.settings, progress, stop, enginesWith(asked.settings.engine));
    if (!study) return tl::make_unexpected(study.error());
    addReading(*study, asked.loaded);
    return std::make_shared<StudyAnswer>(std::make_shared<const Study>(*std::move(study)), asked.scenario);
}

AnswerPage pageOfSavedStudy(const SavedStudy& study, const SavedContent& saved, const LegendChoice& shown) {
    Region region;
    region.name = saved.answer.origin.region;
    return withMonths(makePage(study.field, study.statistics, nameOf(region), shown),
                      makeMonthBars(study.months, study.start, study.field.days));
}

void addSavedMonths(SavedMapBook& book, const SavedStudy& study, const SavedContent&) {
    book.months = makeMonthBars(study.months, study.start, study.field.days);
}

}  // namespace

const Question& studyQuestion() {
    static const Question question{
        .key = "study",
        .label = NM_TEXT("Study"),
        .compute = computeStudy,
        .saved = savedMaps<SavedStudy>(pageOfSavedStudy, drawnByLegend, addSavedMonths),
        .filed = FiledForm{"study", "study.json", "report.pdf"}};
    return question;
}

namespace {

/// The sunlight of points of one scenario: on facades, at windows, on a plane.
class PointsAnswer final : public AnswerOf<ElementAnswer> {
public:
    PointsAnswer(std::shared_ptr<const ElementAnswer> answer, std::string scenario)
        : AnswerOf(std::move(answer)), scenario_(std::move(scenario)) {}

    [[nodiscard]] const Question& question() const override { return pointsQuestion(); }
    [[nodiscard]] const StudySettings* settings() const override { return &content().study.settings; }
    [[nodiscard]] const ElementSettings* points() const override { return &content().study.elements; }
    [[nodiscard]] MeasuredPart part() const override { return {scenario_, {}, settings()->region, {}}; }
    [[nodiscard]] const Warnings& warnings() const override { return content().study.warnings; }
    [[nodiscard]] double seconds() const override { return content().study.seconds.at("total"); }

    [[nodiscard]] std::shared_ptr<const Answer> updated(const Project&, const std::string& scenario,
                                                        const std::string&) const override {
        return scenario == scenario_ ? nullptr : std::make_shared<PointsAnswer>(shared(), scenario);
    }
    [[nodiscard]] std::shared_ptr<const Answer> stated(Provenance provenance) const override {
        auto answer = std::make_shared<ElementAnswer>(content());
        answer->study.provenance = std::move(provenance);
        return std::make_shared<PointsAnswer>(std::move(answer), scenario_);
    }

    [[nodiscard]] AnswerPage page(const LegendChoice&) const override {
        return makePage(content().map, computeFigures(content().study));
    }
    [[nodiscard]] Result<std::string> command() const override { return makeRepeatCommand(content().study); }
    [[nodiscard]] std::vector<CommandOption> drawnOptions(const AnswerFiles& how) const override {
        return drawnByLegend(how);
    }
    [[nodiscard]] std::string json() const override { return elementStudyJson(content().study, {}); }
    [[nodiscard]] SavedResult toSave(const Project& project) const override {
        return makeSavedResult(project, scenario_, content().study);
    }
    [[nodiscard]] std::vector<std::string> fileNames(const AnswerFiles&) const override {
        auto names = elementFileNames(content().study.elements.places);
        names.emplace_back(regionFileName);
        return names;
    }
    [[nodiscard]] Result<std::vector<std::filesystem::path>> write(const City&,
                                                                   const std::filesystem::path& folder,
                                                                   const AnswerFiles& how) const override {
        return writeElementFiles(content().study, bookOf(how), folder, how.rules);
    }
    [[nodiscard]] Result<std::shared_ptr<const Book>> layOut(const std::shared_ptr<const City>&,
                                                             const AnswerFiles& how) const override {
        if (auto map = inColumn(content().map, how.legend.trees)) {
            const auto shown = std::make_shared<const ElementMap>(*std::move(map));
            return bundleBook(makeElementBook(content().study, *shown, bookOf(how)), shared(), shown);
        }
        return bundleBook(makeElementBook(content().study, content().map, bookOf(how)), shared());
    }

private:
    std::string scenario_;
};

// Described before the run, so that the hash is that of what was read.
Result<std::optional<InputFile>> describeGlazing(const ElementSettings& points) {
    if (points.places != ElementPlaces::windows) return std::nullopt;
    if (points.windows.empty())
        return failure("The windows are missing", "windows", "Choose a file of windows");
    return describeInputFile(points.windows).map([](InputFile file) { return std::optional(file); });
}

void addReadingOf(ElementStudy& study, const LoadedCity& loaded) {
    study.provenance = provenanceOf(loaded);
    study.heights = loaded.read.heights;
    prependWarnings(study.warnings, loaded.read.warnings);
    study.seconds["read"] = loaded.seconds;
    study.seconds["total"] += loaded.seconds;
}

Result<std::shared_ptr<const Answer>> computePoints(const Asked& asked, Progress& progress,
                                                    const std::stop_token& stop) {
    auto windows = describeGlazing(*asked.points);
    if (!windows) return tl::make_unexpected(windows.error());
    auto study = runElementStudy(asked.loaded.read.city, asked.settings, *asked.points, progress, stop);
    if (!study) return tl::make_unexpected(study.error());
    study->glazingInput = *std::move(windows);
    addReadingOf(*study, asked.loaded);
    ElementMap map = makeElementMap(*study);
    return std::make_shared<PointsAnswer>(
        std::make_shared<const ElementAnswer>(ElementAnswer{*std::move(study), std::move(map)}),
        asked.scenario);
}

SavedForm savedPoints() {
    return {[](const SavedContent&) { return savedPointNames(); },
            [](const SavedContent& saved, const LegendChoice&) {
                const auto& points = *saved.as<SavedElements>();
                return makePage(points.map, points.figures);
            },
            [](const SavedContent& saved, const SavedSource& source, const std::filesystem::path& folder,
               const AnswerFiles& how, const std::optional<std::string>& sheets) {
                return writeSavedPoints(*saved.result, *saved.as<SavedElements>(), source.city, folder,
                                        {.legend = how.legend, .rules = how.rules, .sheets = sheets});
            },
            [](const SavedContent& saved, const SavedSource& source, const AnswerFiles& how) {
                const auto& points = *saved.as<SavedElements>();
                return std::make_shared<const Book>(
                    makeSavedBook(*saved.result, saved.answer.origin, source, points,
                                  listElementLines(points.figures, {}), bookOf(how)));
            },
            drawnByLegend};
}

}  // namespace

const Question& pointsQuestion() {
    static const Question question{.key = "elements",
                                   .label = NM_TEXT("Study"),
                                   .ofPoints = true,
                                   .compute = computePoints,
                                   .saved = savedPoints(),
                                   .filed = FiledForm{"study", "study.json", "elements.pdf", true}};
    return question;
}

}  // namespace noonmark
