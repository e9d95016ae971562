#pragma once

#include <QColor>
#include <QString>
#include <QTreeWidget>

#include "app/questions/review_question.h"
#include "core/base/units.h"
#include "core/review/criteria/verdict.h"
#include "core/review/glazing/building_review.h"
#include "core/review/rule/rule.h"
#include "core/study/review_study.h"

namespace noonmark {

/// "✓ pass", "✗ fail", "≈ borderline": a verdict is marked by its symbol and word as well as by its colour.
QString describeVerdict(Verdict verdict);
/// The same; "figures only" where the rule states no limit for the place.
QString describeVerdict(const PlaceReview& review);
/// "21 Mar 2026" in the window's language: a day in tables and in describeReason().
std::string writeDay(CivilDate day);
/// "1 ✗ fail, 12 ✓ pass": the worst first, those without a place left out.
QString describeCounts(const VerdictCounts& counts);
/// Read on the background of lists, light or dark, and told apart by people who do not see red and green
/// apart.
QColor verdictColour(Verdict verdict);

/// "1 ✗ fail, 2 ✓ pass": the number of places of each verdict, the worst first.
QString describeVerdicts(const ReviewStudy& study);

/// How sure the figures of a rule are, in a sentence.
QString describeStatus(const Rule& rule);

/// The verdict of each place, those that fail first, and below it the days with the numbers behind it, in the
/// rule's own columns; areas in the units of the project. Of a range of days those with most incremental
/// shadow are listed.
class VerdictTable final : public QTreeWidget {
    Q_OBJECT
public:
    explicit VerdictTable(QWidget* parent = nullptr);

    /// Keeps what is selected if the places are the same. Null: empties the table.
    void show(const std::shared_ptr<const ReviewAnswer>& answer, UnitSystem units);
    /// Emits chosen() for the current row, or else for the first.
    void chooseCurrent();
    /// The whole table as text with tabs, for spreadsheets: a line for each place and day.
    [[nodiscard]] QString text() const;

    static constexpr std::size_t maxDays = 12;  ///< listed of a range, for each place

Q_SIGNALS:
    /// A place, and the day in the row, or else the one that decides its verdict or has most incremental
    /// shadow.
    void chosen(std::size_t review, noonmark::CivilDate day);
    void zoomRequested(std::size_t review);  ///< double click or Enter

private:
    void addPlace(std::size_t review);
    void addDay(QTreeWidgetItem& place, std::size_t review, const ReviewRow& row);
    void choose(const QTreeWidgetItem* item);

    std::shared_ptr<const ReviewAnswer> answer_;
    UnitSystem units_ = UnitSystem::metric;
    std::vector<RuleColumn> columns_;  ///< of the rule in the units shown, without place and day
};

}  // namespace noonmark
