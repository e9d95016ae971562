#pragma once

#include <QDialog>
#include <QTableWidget>

class QMenuBar;

namespace noonmark {

/// What keys and mouse do, as a table that can be searched: the shortcuts of all menu entries as they are,
/// and what the mouse does in the view. Not modal.
class KeySheet final : public QDialog {
    Q_OBJECT
public:
    explicit KeySheet(const QMenuBar& menus, QWidget* parent = nullptr);

    [[nodiscard]] const QTableWidget& table() const { return *table_; }  ///< where, what, keys

private:
    void add(const QString& where, const QString& what, const QString& keys);
    void addMenu(const QString& where, const QList<QAction*>& entries);
    void addMouse();
    void filter(const QString& words);

    QTableWidget* table_;
};

}  // namespace noonmark
