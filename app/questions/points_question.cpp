#include "app/questions/saved_question.h"
#include "app/report/book/element_book.h"
#include "app/report/files/element_files.h"
#include "core/describe/text.h"
#include "core/study/elements/element_map.h"
#include "core/study/elements/element_tables.h"
#include "core/study/elements/repeat_elements.h"
#include "core/study/text/region_text.h"
#include "scenarios/project/results/save_result.h"

namespace noonmark {

namespace {

std::vector<CommandOption> drawnOfPoints(const AnswerFiles& how) {
    return listLegendOptions(how.legend, false);
}

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

    [[nodiscard]] AnswerPage page(ShownAs) const override {
        return makePage(content().map, computeFigures(content().study));
    }
    [[nodiscard]] Result<std::string> command() const override { return makeRepeatCommand(content().study); }
    [[nodiscard]] std::vector<CommandOption> drawnOptions(const AnswerFiles& how) const override {
        return drawnOfPoints(how);
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
        return keepWith(makeElementBook(content().study, content().map, bookOf(how)), shared());
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
    putBefore(study.warnings, loaded.read.warnings);
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
    return {savedPointNames(),
            [](const SavedContent& saved, ShownAs) {
                const auto& points = *saved.as<SavedElements>();
                return makePage(points.map, points.figures);
            },
            [](const SavedContent& saved, const SavedSource& source, const std::filesystem::path& folder,
               const AnswerFiles& how) {
                return writeSavedPoints(*saved.result, *saved.as<SavedElements>(), source.city, folder,
                                        how.legend, how.rules);
            },
            drawnOfPoints};
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
