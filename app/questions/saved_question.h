#pragma once

#include <any>

#include "app/questions/question.h"
#include "app/report/book/answer_books.h"
#include "app/report/files/saved_files.h"
#include "scenarios/project/results/saved_answer.h"

namespace noonmark {

/// The content of an answer that was read back from a project.
struct SavedContent {
    std::shared_ptr<const SavedResult> result;
    SavedAnswer answer;
    std::vector<std::string> changes;        ///< of buildings and files since it was saved, a sentence each
    std::vector<std::string> weightChanges;  ///< of a score's weight table
    [[nodiscard]] bool upToDate() const { return changes.empty() && weightChanges.empty(); }
    /// What was saved, if it is a T: SavedStudy, SavedImpact... ; else null.
    template <class T>
    [[nodiscard]] const T* as() const {
        return std::any_cast<T>(&answer.content);
    }
};

/// Figures by key, of questions without a SavedForm.
using SavedFigureLines = std::vector<FigureLine>;

/// It is read, not computed.
const Question& savedQuestion();

/// For use in a job. Error: as of readSavedAnswer(), of a kind that is no key of `questions` too.
Result<std::shared_ptr<const Answer>> readSaved(const std::shared_ptr<const SavedResult>& result,
                                                const Project& project, Questions questions = allQuestions());

/// What the book of a saved result with maps has of its kind.
template <class T>
using AddSaved = void (*)(SavedMapBook& book, const T&, const SavedContent&);

/// The book of a saved result with maps. `makeSheetOf`: as of writeSavedMaps().
std::shared_ptr<const Book> makeSavedMapBook(const SavedContent& saved, const SavedSource& source,
                                             const AnswerFiles& how,
                                             const std::function<SavedSheet(const SavedMaps&)>& makeSheetOf,
                                             const std::function<void(SavedMapBook&)>& add);

/// How results with maps are written: see writeSavedMaps().
template <class T>
SavedForm savedMaps(AnswerPage (*page)(const T&, const SavedContent&, const LegendChoice&),
                    std::vector<CommandOption> (*drawnOptions)(const AnswerFiles&), AddSaved<T> add) {
    const auto sheetOf = [](const SavedContent& saved) {
        return
            [&saved](const SavedMaps& maps) { return makeSavedSheet(*saved.result, *saved.as<T>(), maps); };
    };
    return {
        [](const SavedContent&) { return savedMapNames(); },
        [page](const SavedContent& saved, const LegendChoice& shown) {
            return page(*saved.as<T>(), saved, shown);
        },
        [sheetOf](const SavedContent& saved, const SavedSource& source, const std::filesystem::path& folder,
                  const AnswerFiles& how, const std::optional<std::string>& sheets) {
            return writeSavedMaps(*saved.result, saved.answer.origin, source, sheetOf(saved), folder,
                                  {how.scale, how.legend, how.pictureWidth, how.rules, sheets});
        },
        [sheetOf, add](const SavedContent& saved, const SavedSource& source, const AnswerFiles& how) {
            return makeSavedMapBook(saved, source, how, sheetOf(saved),
                                    [&](SavedMapBook& book) { add(book, *saved.as<T>(), saved); });
        },
        drawnOptions};
}

}  // namespace noonmark
