#include "app/questions/window_question.h"

#include "app/report/files/window_files.h"
#include "core/base/memory_guard.h"

namespace noonmark {

namespace {

/// The options of the command line that ask for the same windows and sheets.
std::vector<CommandOption> repeatOptions(const WindowQuestion& question, const BookSettings& sheets) {
    std::vector<CommandOption> options = makeRepeatOptions(question.settings.elements);
    options.insert(options.end(), question.repeat.begin(), question.repeat.end());
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
                                         const std::stop_token& stop, const AnnounceWindows& announce) {
    std::optional<InputFile> file;
    if (question.settings.elements.places == ElementPlaces::windows) {
        auto described = describeInputFile(question.settings.elements.windows);
        if (!described) return tl::make_unexpected(described.error());
        file = *std::move(described);
    }
    return guardMemory({.what = "a review"},
                       [&] {
                           return runWindowReview(question.rule, *question.before, *question.after,
                                                  question.settings, progress, stop, announce);
                       })
        .map([&](WindowStudy study) {
            study.windowsFile = std::move(file);
            return WindowAnswer{question, std::move(study)};
        });
}

Result<WrittenWindows> writeWindowReview(WindowAnswer answer, const ReviewSource& source,
                                         const BookSettings& sheets, const std::filesystem::path& folder,
                                         bool byteOrderMark, Progress& progress,
                                         const std::stop_token& stop) {
    const WindowQuestion& asked = answer.question;
    WrittenWindows written{
        std::move(answer.study),
        {asked.from, asked.to, provenanceOf(source, asked), {}, repeatOptions(asked, sheets)},
        {}};
    addWarnings(written.study.warnings, source);
    auto files = writeWindowFiles(
        {written.study, written.labels, *asked.before, *asked.after, source.project.reading->heights}, sheets,
        folder, byteOrderMark, source.outputs, progress, stop);
    if (!files) return tl::make_unexpected(files.error());
    written.files = *std::move(files);
    return written;
}

}  // namespace noonmark
