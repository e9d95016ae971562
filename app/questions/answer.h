#pragma once

// The folder app/questions lists what Noonmark is asked about shadows over cells or points. A Question
// (question.h) computes an Answer (this file) from what the user asks of it (Asked). Window and command line
// show an answer, save it in the project and write its files without knowing which it is: only the file that
// bears the question's name takes it apart. saved_question.h reads back what was saved.

#include <filesystem>
#include <memory>
#include <stop_token>
#include <string>
#include <string_view>
#include <tuple>
#include <typeinfo>
#include <vector>

#include "app/report/book/book.h"
#include "app/report/maps/change_scale.h"
#include "core/describe/answer_page.h"
#include "core/describe/figure_text.h"
#include "core/io/files/check_output.h"
#include "core/study/contributions/place_contributions.h"
#include "core/study/study.h"
#include "scenarios/project/project_provenance.h"

namespace noonmark {

struct ElementSettings;
struct Question;

/// How the files of an answer are written.
struct AnswerFiles {
    ChangeScale scale{};                        ///< of a comparison's picture
    LegendChoice legend{};                      ///< of maps of minutes
    std::optional<double> thresholdHours{};     ///< of the colours of places; none: the hours that are enough
    int pictureWidth = noonmark::pictureWidth;  ///< pixels
    bool cells = false;                         ///< of a study, a table of all cells
    bool sheets = false;                        ///< a book of sheets
    bool byteOrderMark = false;     ///< tables of reviews begin with one, by which Excel recognises UTF-8
    BookSettings book{};            ///< of that, and of the pages of points
    std::vector<Region> regions{};  ///< of the project: a saved result may be of one of them
    OutputRules rules{};            ///< which files may be replaced
    Progress* progress = nullptr;   ///< of the job that writes; null: nobody watches it
    std::stop_token stop{};
};

/// Shares a book together with the values that its pages refer to, which live as long as it.
template <class... T>
std::shared_ptr<const Book> bundleBook(std::shared_ptr<const Book> book,
                                       std::shared_ptr<const T>... referredTo) {
    using Kept = std::tuple<std::shared_ptr<const Book>, std::shared_ptr<const T>...>;
    const auto kept = std::make_shared<const Kept>(std::move(book), std::move(referredTo)...);
    return {kept, std::get<0>(*kept).get()};
}
template <class... T>
std::shared_ptr<const Book> bundleBook(Book book, std::shared_ptr<const T>... referredTo) {
    return bundleBook(std::make_shared<const Book>(std::move(book)), std::move(referredTo)...);
}

/// How its book looks, with the legend of its maps.
inline BookSettings bookOf(const AnswerFiles& how) {
    BookSettings book = how.book;
    book.legend = how.legend;
    return book;
}

/// What a question gave for one scenario of a project. It never changes, so it is shared.
class Answer {
public:
    virtual ~Answer() = default;

    [[nodiscard]] virtual const Question& question() const = 0;
    /// It was saved in a project and is shown as it was then: its question is not asked again.
    [[nodiscard]] bool isSaved() const;
    /// Null: of a review, which asks by a rule, and of a saved result, whose settings are text.
    [[nodiscard]] virtual const StudySettings* settings() const = 0;
    /// Where points were measured; null: cells.
    [[nodiscard]] virtual const ElementSettings* points() const { return nullptr; }
    /// The scenarios, the region and the weights that it depends on.
    [[nodiscard]] virtual MeasuredPart part() const = 0;
    [[nodiscard]] virtual const Warnings& warnings() const = 0;
    [[nodiscard]] virtual double seconds() const = 0;  ///< taken to compute it
    /// Whether both answer the same question about the same scenarios, whatever their buildings.
    [[nodiscard]] virtual bool asksSameAs(const Answer& other) const;

    /// The answer in sentences and charts, of what a legend so chosen shows.
    [[nodiscard]] virtual AnswerPage page(const LegendChoice&) const { return {}; }
    /// The command line that asks the same, of an answer that is stated(); error: why there is none.
    [[nodiscard]] virtual Result<std::string> command() const {
        return failure("No command asks this question", {}, "Ask it in the window");
    }

    /// The options that such a command needs to draw the same.
    [[nodiscard]] virtual std::vector<CommandOption> drawnOptions(const AnswerFiles&) const { return {}; }

    /// Its figures and its minutes by cell, as the window shows those of a question that has no viewer of its
    /// own (app/gui/session/answers/answer_viewer.h).
    [[nodiscard]] virtual std::vector<FigureLine> figures() const { return {}; }
    [[nodiscard]] virtual std::shared_ptr<const ShadowField> field() const { return nullptr; }

    /// The same under the names that its scenarios have now, and as the project now agrees with it; null if
    /// it stays as it is.
    [[nodiscard]] virtual std::shared_ptr<const Answer> updated(const Project& project,
                                                                const std::string& scenario,
                                                                const std::string& baseline) const = 0;
    /// The same with what it was made from, for files. Copies its maps.
    [[nodiscard]] virtual std::shared_ptr<const Answer> stated(Provenance provenance) const = 0;

    /// What buildings take from single places, as far as it was asked for.
    [[nodiscard]] virtual const std::vector<ContributionTable>& ofPlaces() const;
    /// The same with what they take from one more place; null: this answer keeps none.
    [[nodiscard]] virtual std::shared_ptr<const Answer> withPlace(ContributionTable) const { return nullptr; }

    /// The same where so many hours of sun a day are enough; null: it does not depend on them, or its cells
    /// are not known.
    [[nodiscard]] virtual std::shared_ptr<const Answer> withEnough(double) const { return nullptr; }

    [[nodiscard]] virtual std::string json() const = 0;
    /// As a saved result without a name. Costs a hash of each city.
    [[nodiscard]] virtual SavedResult toSave(const Project& project) const = 0;
    /// All that write() may write: whether region.geojson is among it is known only then.
    [[nodiscard]] virtual std::vector<std::string> fileNames(const AnswerFiles& how) const = 0;
    /// The pages that write() files, always or where `how.sheets`, with what they refer to; null: none.
    /// `city`: of its scenario. Errors of laying out; cancelled().
    [[nodiscard]] virtual Result<std::shared_ptr<const Book>> layOut(const std::shared_ptr<const City>& city,
                                                                     const AnswerFiles& how) const;
    /// `city`: of its scenario. All files or none. Needs a QGuiApplication (the `offscreen` platform
    /// suffices).
    [[nodiscard]] virtual Result<std::vector<std::filesystem::path>> write(
        const City& city, const std::filesystem::path& folder, const AnswerFiles& how) const = 0;

    /// Its content, if it is a T: Study, ImpactAnswer, ScoreAnswer, ElementAnswer, SunOfCities,
    /// ReviewAnswer, GlazingAnswer.
    template <class T>
    [[nodiscard]] const T* as() const {
        return static_cast<const T*>(contentOf(typeid(T)));
    }

protected:
    /// Null: its content is of another type.
    [[nodiscard]] virtual const void* contentOf(const std::type_info& type) const = 0;
};

/// An answer with its content.
template <class T>
class AnswerOf : public Answer {
public:
    explicit AnswerOf(std::shared_ptr<const T> content) : content_(std::move(content)) {}

protected:
    [[nodiscard]] const T& content() const { return *content_; }
    [[nodiscard]] const std::shared_ptr<const T>& shared() const { return content_; }
    [[nodiscard]] const void* contentOf(const std::type_info& type) const override {
        return type == typeid(T) ? content_.get() : nullptr;
    }

private:
    std::shared_ptr<const T> content_;
};

/// Its content, which keeps the answer alive; null if it is none or of another type.
template <class T>
std::shared_ptr<const T> contentOf(const std::shared_ptr<const Answer>& answer) {
    const T* content = answer ? answer->as<T>() : nullptr;
    return content ? std::shared_ptr<const T>(answer, content) : nullptr;
}

}  // namespace noonmark
