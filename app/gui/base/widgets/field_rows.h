#pragma once

#include <QObject>
#include <QWidget>
#include <initializer_list>
#include <map>
#include <string>
#include <string_view>

#include "core/describe/field.h"

class QFormLayout;
class QWidget;
class QPushButton;
class QTableWidget;

namespace noonmark {

/// Widgets for the fields of a table: label, tooltip, range, choices and unit are those of the field, in the
/// user's language. Their object names are the fields' flags: "--height-field" is "heightField". A field
/// without a flag goes by its key. Groups, presets and what depends on what are up to the form.
class FieldRows final : public QObject {
    Q_OBJECT
public:
    /// `fields` outlive it.
    explicit FieldRows(std::span<const Field> fields, QObject* parent = nullptr);

    /// The widget of the field with this flag, which the caller places. Made at the first call; it shows the
    /// default.
    QWidget* widget(std::string_view flag);
    /// Places the widgets with their labels; a box has its label beside it.
    void addRows(QFormLayout& form);  ///< of all fields
    void addRows(QFormLayout& form, std::initializer_list<std::string_view> flags);

    void show(const Described& settings);       ///< without a signal
    void take(const Editable& settings) const;  ///< what the widgets hold, into their fields
    /// The same. Error: of the first field, in the table's order, that does not take what its widget holds.
    Result<void> tryTake(const Editable& settings) const;
    /// The same of one field only: widgets round what they show.
    void take(const Editable& settings, std::string_view flag) const;

Q_SIGNALS:
    void edited(const QString& label, const QString& flag);

private:
    [[nodiscard]] const Field* find(std::string_view flag) const;
    QWidget* make(const Field& field);

    std::span<const Field> fields_;
    std::map<const Field*, QWidget*> widgets_;
    bool showing_ = false;
};

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
