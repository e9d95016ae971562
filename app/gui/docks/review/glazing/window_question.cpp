#include "app/gui/docks/review/glazing/window_question.h"

#include "app/report/book/review/review_book.h"
#include "app/report/files/window_files.h"
#include "core/base/memory_guard.h"
#include "scenarios/project/project_provenance.h"

namespace noonmark {

namespace {

/// The options of the command line that ask for the same windows.
std::vector<CommandOption> repeatOptions(const WindowReviewSettings& settings, const BookSettings& sheets) {
    std::vector<CommandOption> options = makeRepeatOptions(settings.elements);
    options.push_back({"--region", {"city"}});
    for (CommandOption& option : makeRepeatOptions(sheets)) options.push_back(std::move(option));
    return options;
}

}  // namespace

bool isSame(const WindowQuestion& a, const WindowQuestion& b) {
    return a.rule.key == b.rule.key && a.rule.chosen == b.rule.chosen && a.before == b.before &&
           a.after == b.after && a.settings.zone == b.settings.zone && a.settings.year == b.settings.year &&
           a.settings.elements == b.settings.elements;
}

Result<WindowAnswer> computeWindowReview(const WindowQuestion& question, Progress& progress,
                                         const std::stop_token& stop) {
    std::optional<InputFile> file;
    if (question.settings.elements.places == ElementPlaces::windows) {
        auto described = describeInputFile(question.settings.elements.windows);
        if (!described) return tl::make_unexpected(described.error());
        file = *std::move(described);
    }
    return guardMemory({.what = "a review"},
                       [&] {
                           return runWindowReview(question.rule, *question.before, *question.after,
                                                  question.settings, progress, stop);
                       })
        .map([&](WindowStudy study) {
            study.windowsFile = std::move(file);
            return WindowAnswer{question, std::move(study)};
        });
}

Result<std::vector<std::filesystem::path>> writeWindowReview(const WindowExport& review,
                                                             const std::filesystem::path& folder,
                                                             Progress& progress,
                                                             const std::stop_token& stop) {
    const WindowQuestion& asked = review.answer->question;
    WindowStudy study = review.answer->study;
    study.warnings.insert(study.warnings.end(), review.ofRules.begin(), review.ofRules.end());
    putBefore(study.warnings, review.project.reading->warnings);
    const ReviewLabels labels{
        asked.from,
        asked.to,
        provenanceOf(review.project, review.file ? &*review.file : nullptr, {asked.to, asked.from, {}, {}}),
        {},
        repeatOptions(asked.settings, review.sheets)};
    return writeWindowFiles({study, labels, *asked.before, *asked.after, review.project.reading->heights},
                            review.sheets, folder, false, review.outputs, progress, stop);
}

}  // namespace noonmark
