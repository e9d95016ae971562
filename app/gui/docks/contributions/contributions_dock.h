#pragma once

#include <QWidget>

#include "app/gui/docks/contributions/contribution_sheet.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QPushButton;
class QSortFilterProxyModel;
class QTableView;

namespace noonmark {

class BarCharts;
class ContributionModel;
class ProgressStrip;

/// What each building takes from the region or a place: a sentence, bars by month, a table that sorts, and
/// the legend of the buildings' colours. Knows neither project nor view: it shows a ContributionSheet.
class ContributionsDock final : public QWidget {
    Q_OBJECT
public:
    explicit ContributionsDock(QWidget* parent = nullptr);

    void setPlaces(const QStringList& names);   ///< that can be chosen, besides the whole region
    void setSubject(const std::string& place);  ///< without a signal; empty: the whole region
    [[nodiscard]] const std::string& subject() const { return subject_; }

    void show(ContributionSheet sheet);
    /// No buildings to show, and why, but months where there are any. `offer`: a button that attributes the
    /// subject's shadow.
    void explain(const QString& why, bool offer = false, const Bars& months = {});
    [[nodiscard]] const ContributionModel& model() const { return *model_; }
    /// Selects the row of a building, if it has one; without a signal. Null: none.
    void select(const Building* building);
    [[nodiscard]] bool colours() const;  ///< the buildings are to be coloured in the view
    /// Not behind another tab, where Qt still takes it for visible.
    [[nodiscard]] bool isInFront() const { return inFront_ && isVisible(); }
    void setInFront(bool inFront);
    [[nodiscard]] ProgressStrip& progress() { return *progress_; }

Q_SIGNALS:
    void subjectChosen(const std::string& place);                        ///< empty: the whole region
    void attributionWanted();                                            ///< the button of explain()
    void pointedAt(std::shared_ptr<const noonmark::Building> building);  ///< the current row
    void wanted(std::shared_ptr<const noonmark::Building> building);     ///< double click or Enter
    void coloursChanged();
    void shownChanged();  ///< the dock was shown or hidden

protected:
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

private:
    void makeFields();
    void makeTable();
    void placeFields();
    void connectFields();
    void chooseSubject(const QString& text);
    [[nodiscard]] QWidget* makeLegend();

    std::string subject_;
    bool inFront_ = true;
    ContributionModel* model_;
    QSortFilterProxyModel* sorted_;
    QComboBox* place_;
    QLabel* headline_;
    QLabel* note_;
    QPushButton* attribute_;
    ProgressStrip* progress_;
    BarCharts* months_;
    QTableView* table_;
    QCheckBox* colours_;
    QWidget* legend_;
};

}  // namespace noonmark
