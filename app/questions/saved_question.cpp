#include "app/questions/saved_question.h"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "app/report/book/print_book.h"
#include "core/describe/text.h"

namespace noonmark {

namespace {

std::vector<std::string> listChanges(const SavedContent& saved) {
    std::vector<std::string> all = saved.changes;
    all.insert(all.end(), saved.weightChanges.begin(), saved.weightChanges.end());
    return all;
}

// Its JSON states it, or why there is none (addRepeat() in provenance_texts.h).
Result<std::string> commandOf(const SavedResult& result) {
    const auto json = nlohmann::ordered_json::parse(result.settings, nullptr, false);
    const auto textOf = [&](const char* key) {
        return json.is_object() && json.contains(key) && json[key].is_string() ? json[key].get<std::string>()
                                                                               : std::string();
    };
    if (std::string command = textOf("repeat"); !command.empty()) return command;
    std::string why = textOf("repeat_note");
    return failure(why.empty() ? "The saved result states no command" : std::move(why), result.name,
                   "Ask the question again");
}

/// A result of any kind as it was saved in the project.
class SavedResultAnswer final : public AnswerOf<SavedContent> {
public:
    SavedResultAnswer(std::shared_ptr<const SavedContent> content, const Question& of)
        : AnswerOf(std::move(content)), of_(of) {}

    [[nodiscard]] const Question& question() const override { return savedQuestion(); }
    [[nodiscard]] const StudySettings* settings() const override { return nullptr; }
    [[nodiscard]] MeasuredPart part() const override {
        return {content().result->scenario, content().result->baseline, {}, content().answer.origin.weights};
    }
    [[nodiscard]] const Warnings& warnings() const override {
        static const Warnings none;
        return none;
    }
    [[nodiscard]] double seconds() const override { return 0; }

    [[nodiscard]] std::shared_ptr<const Answer> updated(const Project& project, const std::string&,
                                                        const std::string&) const override {
        auto changes = findWeightChangesSince(content().answer.origin, project);
        if (changes == content().weightChanges) return nullptr;
        auto now = std::make_shared<SavedContent>(content());
        now->weightChanges = std::move(changes);
        return std::make_shared<SavedResultAnswer>(std::move(now), of_);
    }
    [[nodiscard]] std::shared_ptr<const Answer> stated(Provenance) const override {
        return std::make_shared<SavedResultAnswer>(shared(), of_);
    }

    [[nodiscard]] AnswerPage page(const LegendChoice& shown) const override {
        return of_.saved && of_.saved->page ? of_.saved->page(content(), shown) : AnswerPage{};
    }
    [[nodiscard]] std::vector<FigureLine> figures() const override {
        const auto* lines = content().as<SavedFigureLines>();
        return lines ? *lines : SavedFigureLines();
    }
    [[nodiscard]] Result<std::string> command() const override { return commandOf(*content().result); }

    [[nodiscard]] std::vector<CommandOption> drawnOptions(const AnswerFiles& how) const override {
        const bool draws = of_.saved && of_.saved->drawnOptions;
        return draws ? of_.saved->drawnOptions(how) : std::vector<CommandOption>();
    }
    [[nodiscard]] const std::vector<ContributionTable>& ofPlaces() const override {
        return content().answer.ofPlaces;
    }
    [[nodiscard]] std::string json() const override { return content().result->settings; }
    [[nodiscard]] SavedResult toSave(const Project&) const override { return *content().result; }
    [[nodiscard]] std::vector<std::string> fileNames(const AnswerFiles& how) const override {
        if (!writesItself()) return savedFigureNames();
        std::vector<std::string> names = of_.saved->fileNames(content());
        if (how.sheets) names.emplace_back(sheetsFileName);
        return names;
    }
    [[nodiscard]] Result<std::vector<std::filesystem::path>> write(const City& city,
                                                                   const std::filesystem::path& folder,
                                                                   const AnswerFiles& how) const override {
        const SavedSource source{city, listChanges(content()), how.regions};
        if (!writesItself())
            return writeSavedFigures(*content().result, content().answer.origin, source, figures(), folder,
                                     how.book, how.rules);
        if (!how.sheets) return of_.saved->write(content(), source, folder, how, {});
        const auto pdf = printBook(*of_.saved->book(content(), source, how));
        if (!pdf) return tl::make_unexpected(pdf.error());
        return of_.saved->write(content(), source, folder, how, pdf->toStdString());
    }
    [[nodiscard]] Result<std::shared_ptr<const Book>> layOut(const std::shared_ptr<const City>& city,
                                                             const AnswerFiles& how) const override {
        const SavedSource source{*city, listChanges(content()), how.regions};
        if (!writesItself())
            return bundleBook(
                makeSavedBook(*content().result, content().answer.origin, source, figures(), bookOf(how)),
                shared(), city);
        return bundleBook(of_.saved->book(content(), source, how), shared(), city);
    }

private:
    [[nodiscard]] bool writesItself() const { return of_.saved && of_.saved->write; }

    const Question& of_;
};

// Those that results saved by earlier versions lack, or that only people read, are left out.
SavedFigureLines readLines(std::span<const Figure> figures, const nlohmann::ordered_json& json) {
    SavedFigureLines lines;
    for (const Figure& figure : figures)
        if (figure.inFiles && json.contains(std::string(figure.key)))
            lines.push_back({&figure, figures::readFigure(figure, json)});
    return lines;
}

SavedKind kindOf(const Question& question) {
    const auto known = std::ranges::find(savedKinds(), question.key, &SavedKind::kind);
    if (known != savedKinds().end()) return *known;
    return {question.key, [&question](const SavedResult&, const nlohmann::ordered_json& json) -> std::any {
                return readLines(question.figures, json);
            }};
}

}  // namespace

std::shared_ptr<const Book> makeSavedMapBook(const SavedContent& saved, const SavedSource& source,
                                             const AnswerFiles& how,
                                             const std::function<SavedSheet(const SavedMaps&)>& makeSheetOf,
                                             const std::function<void(SavedMapBook&)>& add) {
    const SavedResult& result = *saved.result;
    const SavedOrigin& origin = saved.answer.origin;
    const auto region = std::make_shared<const Region>(makeSavedRegion(result, origin, source.regions));
    SavedMapBook book{makeSheet(result, origin, makeSheetOf({source.city, *region, how.scale, how.legend}),
                                *region, source),
                      attributionOf(result)};
    add(book);
    return bundleBook(makeSavedBook(book, bookOf(how)), region);
}

Questions allQuestions() {
    static const std::array all{&studyQuestion(),  &comparisonQuestion(), &scoreQuestion(),
                                &pointsQuestion(), &byPlaceQuestion(),    &reviewQuestion(),
                                &glazingQuestion()};
    return all;
}

const Question& savedQuestion() {
    static const Question question{.key = "saved", .label = NM_TEXT("Saved result"), .ofRun = false};
    return question;
}

Result<std::shared_ptr<const Answer>> readSaved(const std::shared_ptr<const SavedResult>& result,
                                                const Project& project, Questions questions) {
    std::vector<SavedKind> kinds;
    const auto of = std::ranges::find(questions, result->kind, &Question::key);
    if (of != questions.end()) kinds.push_back(kindOf(**of));
    return readSavedAnswer(*result, kinds).map([&](SavedAnswer answer) -> std::shared_ptr<const Answer> {
        auto changes = findChangesSince(*result, answer.origin, project);
        auto weightChanges = findWeightChangesSince(answer.origin, project);
        return std::make_shared<SavedResultAnswer>(
            std::make_shared<const SavedContent>(
                SavedContent{result, std::move(answer), std::move(changes), std::move(weightChanges)}),
            **of);
    });
}

}  // namespace noonmark
