#pragma once

#include <QAbstractTableModel>
#include <QWidget>

#include "app/gui/docks/contributions/contribution_sheet.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QPushButton;
class QSortFilterProxyModel;
class QTableView;

namespace noonmark {

/// The table of the buildings of a sheet, one row each, in the sheet's order: the name, then its columns.
class ContributionModel final : public QAbstractTableModel {
    Q_OBJECT
public:
    static constexpr int valueRole = Qt::UserRole;  ///< a number where the text is one, for sorting
    /// Role of the items of a share: how long its bar is, 0 to 1, 1 for the largest share of the sheet.
    static constexpr int barRole = Qt::UserRole + 1;

    using QAbstractTableModel::QAbstractTableModel;

    void show(ContributionSheet sheet);
    [[nodiscard]] const ContributionSheet& sheet() const { return sheet_; }
    [[nodiscard]] int rowOf(const Building* building) const;   ///< -1: not in the table
    [[nodiscard]] int rowOfTree(const std::string& id) const;  ///< likewise

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    ContributionSheet sheet_;
    double largestShare_ = 0;
};

class BarCharts;
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
    /// Selects the row of a building, or of a tree by its id, if it has one; without a signal.
    void select(const Building* building);  ///< null: none
    void selectTree(const std::string& id);
    [[nodiscard]] bool colours() const;  ///< the buildings are to be coloured in the view
    /// Not behind another tab, where Qt still takes it for visible.
    [[nodiscard]] bool isInFront() const { return inFront_ && isVisible(); }
    void setInFront(bool inFront);
    [[nodiscard]] ProgressStrip& progress() { return *progress_; }

Q_SIGNALS:
    void exportRequested();
    void subjectChosen(const std::string& place);       ///< empty: the whole region
    void attributionRequested();                        ///< the button of explain()
    void highlighted(noonmark::ContributionRow row);    ///< the current one
    void goToRequested(noonmark::ContributionRow row);  ///< double click or Enter
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
    void selectRow(int row);
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
    QPushButton* export_;
};

}  // namespace noonmark
