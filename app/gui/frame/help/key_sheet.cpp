#include "app/gui/frame/help/key_sheet.h"

#include <QHeaderView>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QVBoxLayout>

namespace noonmark {

namespace {

/// Of the mouse, and of keys that no menu has.
struct MouseRow {
    const char* where;
    const char* what;
    const char* keys;
};

constexpr MouseRow mouseRows[] = {
    {QT_TRANSLATE_NOOP("KeySheet", "View"), QT_TRANSLATE_NOOP("KeySheet", "Rotate"),
     QT_TRANSLATE_NOOP("KeySheet", "left or middle drag")},
    {QT_TRANSLATE_NOOP("KeySheet", "View"), QT_TRANSLATE_NOOP("KeySheet", "Pan"),
     QT_TRANSLATE_NOOP("KeySheet", "right drag, Shift+drag, arrow keys")},
    {QT_TRANSLATE_NOOP("KeySheet", "View"), QT_TRANSLATE_NOOP("KeySheet", "Zoom to the cursor"),
     QT_TRANSLATE_NOOP("KeySheet", "wheel, + and -")},
    {QT_TRANSLATE_NOOP("KeySheet", "View"), QT_TRANSLATE_NOOP("KeySheet", "Menu of what is there"),
     QT_TRANSLATE_NOOP("KeySheet", "right click")},
    {QT_TRANSLATE_NOOP("KeySheet", "Buildings"), QT_TRANSLATE_NOOP("KeySheet", "Select; another too"),
     QT_TRANSLATE_NOOP("KeySheet", "click; Ctrl+click")},
    {QT_TRANSLATE_NOOP("KeySheet", "Buildings"), QT_TRANSLATE_NOOP("KeySheet", "Select all in a rectangle"),
     QT_TRANSLATE_NOOP("KeySheet", "drag with Ctrl+Shift")},
    {QT_TRANSLATE_NOOP("KeySheet", "Buildings"), QT_TRANSLATE_NOOP("KeySheet", "Change the height"),
     QT_TRANSLATE_NOOP("KeySheet", "drag the arrow, or type the height and press Enter")},
    {QT_TRANSLATE_NOOP("KeySheet", "Buildings"), QT_TRANSLATE_NOOP("KeySheet", "Deselect"),
     QT_TRANSLATE_NOOP("KeySheet", "Esc")},
    {QT_TRANSLATE_NOOP("KeySheet", "Drawing"), QT_TRANSLATE_NOOP("KeySheet", "A corner"),
     QT_TRANSLATE_NOOP("KeySheet", "click; with Shift at right angles, with Ctrl without snapping")},
    {QT_TRANSLATE_NOOP("KeySheet", "Drawing"), QT_TRANSLATE_NOOP("KeySheet", "A side of a stated length"),
     QT_TRANSLATE_NOOP("KeySheet", "type it and press Enter")},
    {QT_TRANSLATE_NOOP("KeySheet", "Drawing"), QT_TRANSLATE_NOOP("KeySheet", "Finish"),
     QT_TRANSLATE_NOOP("KeySheet", "double click, Enter or right click")},
    {QT_TRANSLATE_NOOP("KeySheet", "Drawing"),
     QT_TRANSLATE_NOOP("KeySheet", "Remove the last corner; cancel"),
     QT_TRANSLATE_NOOP("KeySheet", "Backspace; Esc")},
};

QString withoutMarks(QString text) {
    text.remove(u'&');
    while (text.endsWith(u'.')) text.chop(1);
    return text;
}

}  // namespace

KeySheet::KeySheet(const QMenuBar& menus, QWidget* parent) : QDialog(parent), table_(new QTableWidget(0, 3)) {
    setObjectName(QStringLiteral("keySheet"));
    setWindowTitle(tr("Mouse and keys"));
    setAttribute(Qt::WA_DeleteOnClose);
    auto* search = new QLineEdit;
    search->setObjectName(QStringLiteral("keySearch"));
    search->setPlaceholderText(tr("Find a key or what it does"));
    search->setToolTip(tr("Shows the rows that contain these words"));
    search->setClearButtonEnabled(true);
    connect(search, &QLineEdit::textChanged, this, &KeySheet::filter);
    table_->setHorizontalHeaderLabels({tr("Where"), tr("What"), tr("Keys, mouse")});
    table_->setAccessibleName(windowTitle());
    table_->verticalHeader()->hide();
    table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
    table_->setSelectionBehavior(QAbstractItemView::SelectRows);
    table_->setAlternatingRowColors(true);
    addMouse();
    for (const QAction* menu : menus.actions())
        if (menu->menu() != nullptr) addMenu(withoutMarks(menu->text()), menu->menu()->actions());
    table_->resizeColumnsToContents();
    table_->horizontalHeader()->setStretchLastSection(true);
    auto* column = new QVBoxLayout(this);
    column->addWidget(search);
    column->addWidget(table_);
    resize(760, 620);
}

void KeySheet::add(const QString& where, const QString& what, const QString& keys) {
    const int row = table_->rowCount();
    table_->insertRow(row);
    const QString texts[] = {where, what, keys};
    for (int column = 0; column < 3; ++column)
        table_->setItem(row, column, new QTableWidgetItem(texts[column]));
}

void KeySheet::addMouse() {
    for (const MouseRow& row : mouseRows) add(tr(row.where), tr(row.what), tr(row.keys));
}

void KeySheet::addMenu(const QString& where, const QList<QAction*>& entries) {
    for (const QAction* entry : entries) {
        if (entry->menu() != nullptr) addMenu(where, entry->menu()->actions());
        QStringList keys;
        for (const QKeySequence& one : entry->shortcuts()) keys << one.toString(QKeySequence::NativeText);
        if (!keys.isEmpty()) add(where, withoutMarks(entry->text()), keys.join(QStringLiteral(", ")));
    }
}

void KeySheet::filter(const QString& words) {
    for (int row = 0; row < table_->rowCount(); ++row) {
        bool found = false;
        for (int column = 0; column < 3; ++column)
            found = found || table_->item(row, column)->text().contains(words, Qt::CaseInsensitive);
        table_->setRowHidden(row, !found);
    }
}

}  // namespace noonmark
