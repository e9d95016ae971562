#pragma once

#include <QObject>
#include <QStringList>
#include <QTableView>

class QHeaderView;
class QMenu;
class QSettings;

namespace noonmark {

/// A menu of the columns of a table, by right-click on its heading: the ticked ones are shown. What is
/// hidden is saved in the settings. The first column is always shown. Belongs to the heading.
class ColumnMenu final : public QObject {
    Q_OBJECT
public:
    /// `keyRole`: of the model's headings, texts that are the same in all languages. `settings` must outlive
    /// the heading; `setting` is its key there.
    ColumnMenu(QHeaderView& heading, int keyRole, QSettings& settings, const QString& setting);

    /// A menu that shows and hides all columns but the first, in their order. The caller deletes it.
    [[nodiscard]] QMenu* makeMenu();

private:
    void show(int column, bool shown);
    [[nodiscard]] QString keyOf(int column) const;

    QHeaderView& heading_;
    int keyRole_;
    QSettings& settings_;
    QString setting_;
};

/// The first column of a table, which stays in sight when the table is scrolled sideways. Lies over the
/// table, its parent, and shares its model, selection and sorting; create it once the table has a model.
class FrozenColumn final : public QTableView {
    Q_OBJECT
public:
    explicit FrozenColumn(QTableView& table);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void followColumns();
    void followSorting();
    void followScrolling();
    void place();

    QTableView& table_;
};

}  // namespace noonmark
