#include "app/gui/base/widgets/field_rows.h"

#include <QCheckBox>
#include <QComboBox>
#include <QCompleter>
#include <QDateEdit>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLineEdit>
#include <QPushButton>
#include <QScopedValueRollback>
#include <QSpinBox>
#include <QTableWidget>
#include <QTimeEdit>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "app/gui/base/widgets/error_text.h"
#include "app/gui/base/widgets/number_fields.h"
#include "core/describe/field_values.h"
#include "core/sun/civil_time.h"

namespace noonmark {

namespace {

// "--height-field" -> "heightField"
QString objectNameOf(const Field& field) {
    QString name;
    bool upper = false;
    for (const char letter : nameOf(field)) {
        if (letter != '-') name += upper ? QChar(letter).toUpper() : QChar(letter);
        upper = letter == '-';
    }
    return name;
}

double numberOf(const Value& value) {
    if (const auto* whole = std::get_if<std::int64_t>(&value)) return double(*whole);
    const double* number = std::get_if<double>(&value);
    return number ? *number : 0;
}

// The least value is the default and stands for none.
bool canBeNone(const Field& field) {
    return field.range && !field.whenEmpty.empty() && field.range->min == numberOf(field.standard);
}

// An optional number has one more value below its range, which stands for none.
bool hasNoneBelow(const Field& field) { return field.isOptional && field.range.has_value(); }

// A tenth of the default's power of ten: 0.1 for 3.2, 1000 for 60000.
double stepOf(const Field& field) {
    if (canBeNone(field)) return field.range->max * field.shownTimes / 20;
    const double standard = std::abs(numberOf(field.standard));
    return standard > 0 ? std::pow(10.0, std::floor(std::log10(standard)) - 1) : 1;
}

// At most 4; none for numbers that need more: 3 for 0.005.
int decimalsIn(double number) {
    for (int decimals = 0; decimals <= 4; ++decimals) {
        const double grains = number * std::pow(10.0, decimals);
        if (std::abs(grains - std::round(grains)) < 1e-6) return decimals;
    }
    return 0;
}

int decimalsOf(const Field& field, const ValueRange& shown) {
    // Directions, as drawings state them; other angles are small.
    if (field.unit == "deg" && shown.max > 90) return 4;
    const int fewest = stepOf(field) >= 10 ? 0 : 2;
    return std::max({fewest, decimalsIn(numberOf(field.standard) * field.shownTimes), decimalsIn(shown.min)});
}

QString unitOf(const Field& field) {
    if (field.unit.empty()) return {};
    if (field.unit == "m2") return QStringLiteral(" m²");
    return field.unit == "deg" ? QStringLiteral("°") : QLatin1Char(' ') + translated(field.unit);
}

QWidget* makeNumber(const Field& field) {
    ValueRange range = field.range.value_or(ValueRange{-1e9, 1e9});
    range = {range.min * field.shownTimes, range.max * field.shownTimes};
    const int decimals = decimalsOf(field, range);
    const double lastDigit = std::pow(10.0, -decimals), step = std::max(stepOf(field), lastDigit);
    if (hasNoneBelow(field)) range.min -= lastDigit;
    QDoubleSpinBox* number = field.unit == "m"
                                 ? lengthField(range.min, range.max, decimals, step)
                                 : numberField(range.min, range.max, decimals, step, unitOf(field));
    if (canBeNone(field) || hasNoneBelow(field)) number->setSpecialValueText(translated(field.whenEmpty));
    return number;
}

QWidget* makeWhole(const Field& field) {
    const ValueRange range = field.range.value_or(ValueRange{0, 1e9});
    QSpinBox* number = wholeField(int(range.min), int(range.max), unitOf(field));
    if (canBeNone(field)) number->setSpecialValueText(translated(field.whenEmpty));
    return number;
}

QWidget* makeChoices(const Field& field) {
    auto* list = new QComboBox;
    if (field.isOptional) list->addItem(translated(field.whenEmpty));
    for (const KeyedLabel& choice : field.choices)
        list->addItem(translated(choice.label), QString::fromStdString(std::string(choice.key)));
    return list;
}

QWidget* makeDate() {
    auto* date = new QDateEdit;
    date->setCalendarPopup(true);
    date->setDisplayFormat(QStringLiteral("yyyy-MM-dd"));
    date->setDateRange(QDate(1900, 1, 2), QDate(2099, 12, 30));  // the ephemeris' years
    return date;
}

QWidget* makeTime() {
    auto* time = new QTimeEdit;
    time->setDisplayFormat(QStringLiteral("HH:mm"));
    return time;
}

QWidget* makeZone() {
    auto* zone = new QComboBox;
    zone->setEditable(true);
    zone->setInsertPolicy(QComboBox::NoInsert);
    for (const std::string& name : zoneNames()) zone->addItem(QString::fromStdString(name));
    zone->completer()->setCompletionMode(QCompleter::PopupCompletion);
    zone->completer()->setFilterMode(Qt::MatchContains);
    zone->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    zone->setMinimumContentsLength(14);
    return zone;
}

QWidget* makeText(const Field& field) {
    if (field.entry == TextEntry::date) return makeDate();
    if (field.entry == TextEntry::timeOfDay) return makeTime();
    if (field.entry == TextEntry::zone) return makeZone();
    auto* line = new QLineEdit;
    if (!field.whenEmpty.empty()) line->setPlaceholderText(translated(field.whenEmpty));
    return line;
}

QWidget* makeWidget(const Field& field) {
    switch (field.kind) {
        case ValueKind::yesNo:
            return new QCheckBox(translated(field.label));
        case ValueKind::whole:
            return makeWhole(field);
        case ValueKind::number:
            return makeNumber(field);
        case ValueKind::choice:
            return makeChoices(field);
        default:
            return makeText(field);
    }
}

// 24:00 ends a day, and a field of the hours begins it.
QTime timeIn(const QString& text) {
    return text.startsWith(QStringLiteral("24:")) ? QTime(0, 0)
                                                  : QTime::fromString(text, QStringLiteral("HH:mm"));
}

void showValue(QWidget& widget, const Field& field, const Value& value) {
    const QString text = QString::fromStdString(formatText(value));
    if (auto* box = qobject_cast<QCheckBox*>(&widget)) box->setChecked(value == Value(true));
    if (auto* whole = qobject_cast<QSpinBox*>(&widget)) whole->setValue(int(numberOf(value)));
    if (auto* number = qobject_cast<QDoubleSpinBox*>(&widget))
        number->setValue(value == Value() ? number->minimum() : numberOf(value) * field.shownTimes);
    if (auto* list = qobject_cast<QComboBox*>(&widget))
        list->isEditable() ? list->setCurrentText(text)
                           : list->setCurrentIndex(value == Value() ? 0 : list->findData(text));
    if (auto* date = qobject_cast<QDateEdit*>(&widget)) date->setDate(QDate::fromString(text, Qt::ISODate));
    if (auto* time = qobject_cast<QTimeEdit*>(&widget)) time->setTime(timeIn(text));
    if (auto* line = qobject_cast<QLineEdit*>(&widget)) line->setText(text);
}

// What a text field holds that is not of the field's kind leaves the field as it is.
Result<Value> valueOf(const Field& field, const QWidget& widget) {
    if (const auto* box = qobject_cast<const QCheckBox*>(&widget)) return Value(box->isChecked());
    if (const auto* whole = qobject_cast<const QSpinBox*>(&widget))
        return Value(std::int64_t(whole->value()));
    if (const auto* number = qobject_cast<const QDoubleSpinBox*>(&widget))
        return hasNoneBelow(field) && number->value() == number->minimum()
                   ? Value()
                   : Value(number->value() / field.shownTimes);
    if (const auto* moment = qobject_cast<const QDateTimeEdit*>(&widget))
        return Value(moment->text().toStdString());
    if (const auto* list = qobject_cast<const QComboBox*>(&widget); list && list->isEditable())
        return Value(list->currentText().trimmed().toStdString());
    if (const auto* list = qobject_cast<const QComboBox*>(&widget)) {
        const QString key = list->currentData().toString();
        return key.isEmpty() ? Value() : Value(key.toStdString());
    }
    const auto* line = qobject_cast<const QLineEdit*>(&widget);
    const std::string text = line ? line->text().trimmed().toStdString() : std::string();
    return text.empty() && field.kind != ValueKind::text ? Result<Value>(field.standard)
                                                         : parseValue(field, text);
}

}  // namespace

FieldRows::FieldRows(std::span<const Field> fields, QObject* parent) : QObject(parent), fields_(fields) {}

const Field* FieldRows::find(std::string_view flag) const {
    const auto found = std::ranges::find(
        fields_, flag, [](const Field& field) { return field.flag.empty() ? field.key : field.flag; });
    return found == fields_.end() ? nullptr : &*found;
}

QWidget* FieldRows::widget(std::string_view flag) {
    const Field* field = find(flag);
    if (!field) return nullptr;
    QWidget*& widget = widgets_[field];
    if (!widget) widget = make(*field);
    return widget;
}

QWidget* FieldRows::make(const Field& field) {
    QWidget* widget = makeWidget(field);
    widget->setObjectName(objectNameOf(field));
    widget->setToolTip(translated(field.help));
    showValue(*widget, field, field.standard);
    const auto changed = [this, &field] {
        if (!showing_)
            Q_EMIT edited(translated(field.label), QString::fromStdString(std::string(field.flag)));
    };
    if (auto* box = qobject_cast<QCheckBox*>(widget)) connect(box, &QCheckBox::toggled, this, changed);
    if (auto* whole = qobject_cast<QSpinBox*>(widget)) connect(whole, &QSpinBox::valueChanged, this, changed);
    if (auto* number = qobject_cast<QDoubleSpinBox*>(widget))
        connect(number, &QDoubleSpinBox::valueChanged, this, changed);
    if (auto* list = qobject_cast<QComboBox*>(widget)) {
        connect(list, &QComboBox::currentIndexChanged, this, changed);
        if (list->isEditable()) connect(list->lineEdit(), &QLineEdit::editingFinished, this, changed);
    }
    if (auto* moment = qobject_cast<QDateTimeEdit*>(widget))
        connect(moment, &QDateTimeEdit::dateTimeChanged, this, changed);
    if (auto* line = qobject_cast<QLineEdit*>(widget))
        connect(line, &QLineEdit::editingFinished, this, changed);
    return widget;
}

void FieldRows::addRows(QFormLayout& form) {
    for (const Field& field : fields_) addRows(form, {field.flag.empty() ? field.key : field.flag});
}

void FieldRows::addRows(QFormLayout& form, std::initializer_list<std::string_view> flags) {
    for (const std::string_view flag : flags) {
        QWidget* field = widget(flag);
        if (!field) continue;
        const bool isBox = qobject_cast<QCheckBox*>(field) != nullptr;
        form.addRow(isBox ? QString() : translated(find(flag)->label), field);
    }
}

void FieldRows::show(const Described& settings) {
    const QScopedValueRollback<bool> quiet(showing_, true);
    for (const auto& [field, widget] : widgets_) showValue(*widget, *field, settings.get(*field));
}

void FieldRows::take(const Editable& settings, std::string_view flag) const {
    const auto found = widgets_.find(find(flag));
    if (found == widgets_.end()) return;
    if (const auto value = valueOf(*found->first, *found->second)) (void)settings.set(*found->first, *value);
}

void FieldRows::take(const Editable& settings) const { (void)tryTake(settings); }

// All fields that can be taken are.
Result<void> FieldRows::tryTake(const Editable& settings) const {
    Result<void> taken;
    for (const auto& [field, widget] : widgets_) {
        const Result<void> set = valueOf(*field, *widget).and_then([&, field = field](const Value& value) {
            return settings.set(*field, value);
        });
        if (!set && taken) taken = set;
    }
    return taken;
}

namespace {

constexpr int visibleRows = 3;

// Without rows it takes no room: its buttons say what it holds.
void fitHeight(QTableWidget& table) {
    const int rows = std::min(table.rowCount(), visibleRows);
    table.setFixedHeight(table.horizontalHeader()->sizeHint().height() +
                         rows * table.verticalHeader()->defaultSectionSize() + 4);
    table.setVisible(rows > 0);
}

QTableWidget* makeTable(int columns) {
    auto* table = new QTableWidget(0, columns);
    table->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
    table->verticalHeader()->hide();
    table->setSelectionBehavior(QAbstractItemView::SelectRows);
    return table;
}

}  // namespace

FieldTable::FieldTable(int columns, QPushButton* add, QPushButton* remove, QWidget* parent)
    : QWidget(parent), table_(makeTable(columns)), remove_(remove) {
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(add);
    buttons->addWidget(remove);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(table_);
    column->addLayout(buttons);
    remove->setEnabled(false);
    fitHeight(*table_);
    connect(add, &QPushButton::clicked, this, &FieldTable::addRequested);
    connect(remove, &QPushButton::clicked, this, &FieldTable::removeChosen);
}

void FieldTable::addRow(std::initializer_list<QWidget*> fields) {
    const int row = table_->rowCount();
    table_->insertRow(row);
    int column = 0;
    for (QWidget* field : fields) table_->setCellWidget(row, column++, field);
    remove_->setEnabled(true);
    fitHeight(*table_);
}

void FieldTable::removeRows() {
    table_->setRowCount(0);
    remove_->setEnabled(false);
    fitHeight(*table_);
}

void FieldTable::removeChosen() {
    const int chosen = table_->currentRow() >= 0 ? table_->currentRow() : table_->rowCount() - 1;
    table_->removeRow(chosen);
    fitHeight(*table_);
    remove_->setEnabled(table_->rowCount() > 0);
    Q_EMIT edited();
}

}  // namespace noonmark
