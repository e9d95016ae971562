#pragma once

#include <QTreeWidget>

#include "app/questions/review_question.h"
#include "core/base/display_units.h"

namespace noonmark {

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
