#pragma once

#include <QWidget>

#include "app/gui/docks/review/review_session.h"
#include "core/base/units.h"

class QLabel;
class QPushButton;
class QStackedWidget;
class QTabWidget;
class QTextBrowser;

namespace noonmark {

class DayPanel;
class ProjectSession;
class RangePanel;
class VerdictTable;
struct GlazingAnswer;
class GlazingPanel;
class GlazingSession;
class GlazingTable;

/// Shows the verdicts of a review (ReviewForm asks for it) with the numbers behind them, the timeline of the
/// chosen place, and what the rule rests on. Empty, it states what to do next.
class ReviewDock final : public QWidget {
    Q_OBJECT
public:
    /// All must outlive it.
    ReviewDock(ReviewSession& review, GlazingSession& windows, ProjectSession& project,
               QWidget* parent = nullptr);

    [[nodiscard]] VerdictTable& table() { return *table_; }
    [[nodiscard]] GlazingPanel& glazingPanel() { return *glazingPanel_; }
    [[nodiscard]] GlazingTable& glazingTable() { return glazingTable_; }
    [[nodiscard]] DayPanel& day() { return *day_; }
    [[nodiscard]] RangePanel& range() { return *range_; }
    void copyTable();

Q_SIGNALS:
    void placePointedAt(const std::string& place);  ///< to be highlighted in the view
    void zoomRequested(const std::string& place);
    void exportRequested();

protected:
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

private:
    QWidget* makeTable();
    QWidget* makeCharts();
    void connectSession();
    void connectTable();
    void showChoice();
    void showAnswer();
    void showUnits();
    void showState();
    void showGlazing();
    void showGlazingState();
    void showChart();
    void showDetails();
    void showRule();

    ReviewSession& review_;
    GlazingSession& windows_;
    ProjectSession& project_;
    QPushButton* copy_;
    QPushButton* export_;
    QLabel* state_;
    QLabel* details_;         ///< of the chosen place
    QStackedWidget* tables_;  ///< table_ or glazingPanel_
    VerdictTable* table_;
    GlazingPanel* glazingPanel_;
    GlazingTable& glazingTable_;  ///< of glazingPanel_
    QTabWidget* tabs_;
    DayPanel* day_;
    RangePanel* range_;
    QTextBrowser* about_;
    std::shared_ptr<const ReviewAnswer> answer_;  ///< in the table
    std::shared_ptr<const GlazingAnswer> glazingAnswer_;
    UnitSystem units_ = UnitSystem::metric;  ///< in which all is shown
    std::size_t chosen_ = 0;                 ///< review whose charts are shown
    std::optional<CivilDate> chosenDay_;
};

}  // namespace noonmark
