#pragma once

#include <QWidget>
#include <initializer_list>

class QPushButton;
class QTableWidget;

namespace noonmark {

/// A table of three visible rows of fields above two buttons: `add` requests a row, `remove` removes the
/// selected row or the last one.
class FieldTable : public QWidget {
    Q_OBJECT
public:
    FieldTable(int columns, QPushButton* add, QPushButton* remove, QWidget* parent);

Q_SIGNALS:
    void edited();
    void addRequested();

protected:
    [[nodiscard]] QTableWidget& table() const { return *table_; }
    void addRow(std::initializer_list<QWidget*> fields);  ///< one per column
    void removeRows();                                    ///< all, without a signal

private:
    void removeChosen();

    QTableWidget* table_;
    QPushButton* remove_;
};

}  // namespace noonmark
