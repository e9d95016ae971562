#pragma once

#include <QTableView>

namespace noonmark {

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
