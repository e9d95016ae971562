#include "tests/golden/window_text.h"

#include <QAbstractButton>
#include <QAbstractItemModel>
#include <QAbstractItemView>
#include <QAbstractSlider>
#include <QComboBox>
#include <QDateTimeEdit>
#include <QDialog>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QGroupBox>
#include <QLabel>
#include <QLayout>
#include <QLineEdit>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>
#include <QPlainTextEdit>
#include <QProgressBar>
#include <QSpinBox>
#include <QSplitter>
#include <QStatusBar>
#include <QTabBar>
#include <QTabWidget>
#include <QTableView>
#include <QTextEdit>
#include <QToolBar>
#include <QTreeView>
#include <algorithm>
#include <array>

#include "tests/golden/painted_text.h"

namespace noonmark::golden {

namespace {

constexpr int maxEntries = 100;  // of a list that is written out: time zones are not

QString quoted(QString text) {
    return u'"' + text.replace(u'\\', QStringLiteral("\\\\")).replace(u'\n', QStringLiteral("\\n")) + u'"';
}

/// ` name "text"`, or nothing for an empty text.
QString labelled(const char* name, const QString& text) {
    return text.isEmpty() ? QString() : QStringLiteral(" %1 %2").arg(QLatin1String(name), quoted(text));
}

QString nameOf(const QObject& object) {
    const QString name = object.objectName();
    return name.isEmpty() || name.startsWith(u"qt_") ? QString() : u' ' + name;
}

/// A word that holds, or nothing.
QString word(const char* text, bool holds) { return holds ? u' ' + QLatin1String(text) : QString(); }

/// The nearest class of Qt: those of the window may be renamed.
QString kindOf(const QWidget& widget) {
    const QMetaObject* type = widget.metaObject();
    while (*type->className() != 'Q') type = type->superClass();
    return QString::fromLatin1(type->className());
}

bool isQtsOwn(const QWidget& widget) { return *widget.metaObject()->className() == 'Q'; }

// --- Tables and trees

QString describeCell(const QModelIndex& cell) {
    const QVariant check = cell.data(Qt::CheckStateRole), colour = cell.data(Qt::ForegroundRole);
    const QVariant font = cell.data(Qt::FontRole);
    QString text = quoted(cell.data().toString());
    text += word("ticked", check.isValid() && check.toInt() != Qt::Unchecked) +
            word("not ticked", check.isValid() && check.toInt() == Qt::Unchecked);
    if (colour.isValid()) text += u' ' + colour.value<QBrush>().color().name();
    text += word("bold", font.isValid() && font.value<QFont>().bold());
    text += word("off", !(cell.flags() & Qt::ItemIsEnabled));
    text += word("editable", bool(cell.flags() & Qt::ItemIsEditable));
    return text + labelled("tip", cell.data(Qt::ToolTipRole).toString());
}

void addRows(QStringList& lines, const QString& indent, const QAbstractItemView& view,
             const QModelIndex& parent) {
    const QAbstractItemModel& model = *view.model();
    const auto* tree = qobject_cast<const QTreeView*>(&view);
    for (int row = 0; row < model.rowCount(parent); ++row) {
        const QModelIndex first = model.index(row, 0, parent);
        QStringList cells;
        for (int column = 0; column < model.columnCount(parent); ++column)
            cells << describeCell(model.index(row, column, parent));
        lines << indent + QStringLiteral("- ") + cells.join(QStringLiteral(" | ")) +
                     word("(open)", tree != nullptr && model.hasChildren(first) && tree->isExpanded(first)) +
                     word("(current)",
                          view.currentIndex().isValid() && view.currentIndex().siblingAtColumn(0) == first);
        addRows(lines, indent + QStringLiteral("    "), view, first);
    }
}

void addHeadings(QStringList& lines, const QString& indent, const QAbstractItemView& view) {
    const auto* table = qobject_cast<const QTableView*>(&view);
    const auto* tree = qobject_cast<const QTreeView*>(&view);
    QStringList headings;
    for (int column = 0; column < view.model()->columnCount(); ++column) {
        const auto heading = [&](int role) {
            return view.model()->headerData(column, Qt::Horizontal, role).toString();
        };
        const bool hidden = (table != nullptr && table->isColumnHidden(column)) ||
                            (tree != nullptr && tree->isColumnHidden(column));
        headings << quoted(heading(Qt::DisplayRole)) + word("hidden", hidden) +
                        labelled("tip", heading(Qt::ToolTipRole));
    }
    if (table != nullptr || tree != nullptr)
        lines << indent + QStringLiteral("= ") + headings.join(QStringLiteral(" | "));
}

void addModel(QStringList& lines, const QString& indent, const QAbstractItemView& view) {
    if (view.model() == nullptr) return;
    addHeadings(lines, indent, view);
    addRows(lines, indent, view, view.rootIndex());
}

// --- Values

QString describeList(const QComboBox& list) {
    const QString current = QStringLiteral(" = %1 of ").arg(quoted(list.currentText()));
    if (list.count() > maxEntries) return current + QStringLiteral("%1 entries").arg(list.count());
    QStringList entries;
    for (int i = 0; i < list.count(); ++i)
        entries << quoted(list.itemText(i)) + labelled("tip", list.itemData(i, Qt::ToolTipRole).toString());
    return current + u'[' + entries.join(QStringLiteral(", ")) + u']';
}

QString describeRange(double low, double high) { return QStringLiteral(" (%1 to %2)").arg(low).arg(high); }

QString describeSpinBox(const QAbstractSpinBox& box) {
    QString range;
    if (const auto* whole = qobject_cast<const QSpinBox*>(&box))
        range = describeRange(whole->minimum(), whole->maximum());
    if (const auto* number = qobject_cast<const QDoubleSpinBox*>(&box))
        range = describeRange(number->minimum(), number->maximum());
    return QStringLiteral(" = ") + quoted(box.text()) + range;
}

QString describeButton(const QAbstractButton& button) {
    return u' ' + quoted(button.text()) + word("checked", button.isChecked());
}

QString describeTabs(const QTabBar& tabs) {
    QStringList names;
    for (int i = 0; i < tabs.count(); ++i) names << quoted(tabs.tabText(i));
    // Docks that share a place: which came first depends on how the window was laid out.
    if (tabs.currentIndex() < 0) return {};
    return QStringLiteral(" = %1 of [%2]")
        .arg(quoted(tabs.tabText(tabs.currentIndex())), names.join(QStringLiteral(", ")));
}

QString valueOf(const QWidget& widget) {
    if (const auto* label = qobject_cast<const QLabel*>(&widget))
        return u' ' + quoted(label->text()) + word("picture", !label->pixmap(Qt::ReturnByValue).isNull());
    if (const auto* button = qobject_cast<const QAbstractButton*>(&widget)) return describeButton(*button);
    if (const auto* list = qobject_cast<const QComboBox*>(&widget)) return describeList(*list);
    if (const auto* box = qobject_cast<const QAbstractSpinBox*>(&widget)) return describeSpinBox(*box);
    if (const auto* line = qobject_cast<const QLineEdit*>(&widget))
        return QStringLiteral(" = ") + quoted(line->text()) + labelled("empty", line->placeholderText());
    if (const auto* slider = qobject_cast<const QAbstractSlider*>(&widget))
        return QStringLiteral(" = %1").arg(slider->value()) +
               describeRange(slider->minimum(), slider->maximum());
    if (const auto* text = qobject_cast<const QTextEdit*>(&widget))
        return QStringLiteral(" = ") + quoted(text->toPlainText());
    if (const auto* text = qobject_cast<const QPlainTextEdit*>(&widget))
        return QStringLiteral(" = ") + quoted(text->toPlainText());
    if (const auto* group = qobject_cast<const QGroupBox*>(&widget))
        return u' ' + quoted(group->title()) + word("checked", group->isChecked());
    if (const auto* tabs = qobject_cast<const QTabBar*>(&widget)) return describeTabs(*tabs);
    return {};
}

// --- Widgets

/// Shown with its parent, or not worth a word. What a hidden progress bar said last depends on the speed.
bool isPartOfItsParent(const QWidget& widget) {
    constexpr std::array kinds{"QScrollBar",         "QHeaderView",
                               "QTableCornerButton", "QComboBoxPrivateContainer",
                               "QSplitterHandle",    "QSizeGrip"};
    const QString& name = widget.objectName();
    return std::ranges::any_of(kinds, [&](const char* kind) { return widget.inherits(kind); }) ||
           name == u"qt_spinbox_lineedit" || name.startsWith(u"qt_scrollarea_hcontainer") ||
           name.startsWith(u"qt_scrollarea_vcontainer") || name.startsWith(u"Scroll") ||
           (widget.isHidden() && widget.findChild<QProgressBar*>() != nullptr);
}

/// Its value says it all.
bool isLeaf(const QWidget& widget) {
    return qobject_cast<const QComboBox*>(&widget) != nullptr ||
           qobject_cast<const QAbstractSpinBox*>(&widget) != nullptr ||
           qobject_cast<const QLineEdit*>(&widget) != nullptr ||
           qobject_cast<const QAbstractButton*>(&widget) != nullptr ||
           qobject_cast<const QTextEdit*>(&widget) != nullptr ||
           qobject_cast<const QMenuBar*>(&widget) != nullptr;
}

void addLaidOut(QList<QWidget*>& widgets, const QLayout& layout) {
    for (int i = 0; i < layout.count(); ++i) {
        QLayoutItem* item = layout.itemAt(i);
        if (item->widget() != nullptr) widgets << item->widget();
        if (item->layout() != nullptr) addLaidOut(widgets, *item->layout());
    }
}

/// In the order of its layout, whatever the order in which they were made; then those without a layout.
QList<QWidget*> childrenOf(const QWidget& widget) {
    QList<QWidget*> found;
    const auto* splitter = qobject_cast<const QSplitter*>(&widget);
    for (int i = 0; splitter != nullptr && i < splitter->count(); ++i) found << splitter->widget(i);
    if (widget.layout() != nullptr) addLaidOut(found, *widget.layout());
    for (QWidget* child : widget.findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly))
        if (!found.contains(child)) found << child;
    found.removeIf([](const QWidget* child) {
        return child->isWindow() || isPartOfItsParent(*child) || child->objectName() == u"messageBar";
    });
    return found;
}

void addWidget(QStringList& lines, const QString& indent, QWidget& widget);

void addChildren(QStringList& lines, const QString& indent, const QWidget& widget) {
    for (QWidget* child : childrenOf(widget)) addWidget(lines, indent, *child);
}

/// What only holds others is not worth a line.
bool isBare(const QWidget& widget, const QString& value) {
    return value.isEmpty() && widget.toolTip().isEmpty() && nameOf(widget).isEmpty() && widget.isEnabled() &&
           !widget.isHidden() && kindOf(widget) == u"QWidget";
}

/// The value, and what the widget paints itself.
QString wordsOf(QWidget& widget) {
    const bool own = !isQtsOwn(widget) && (kindOf(widget) == u"QWidget" || kindOf(widget) == u"QFrame");
    if (!own || !widget.isVisible()) return valueOf(widget);
    return valueOf(widget) + labelled("painted", paintedText(widget).join(QStringLiteral(" | ")));
}

void addWidget(QStringList& lines, const QString& indent, QWidget& widget) {
    const QString value = wordsOf(widget);
    const bool bare = isBare(widget, value);
    if (!bare)
        lines << indent + kindOf(widget) + nameOf(widget) + value + word("hidden", widget.isHidden()) +
                     word("off", !widget.isEnabled()) + labelled("tip", widget.toolTip());
    const QString inner = bare ? indent : indent + QStringLiteral("  ");
    if (const auto* view = qobject_cast<const QAbstractItemView*>(&widget)) addModel(lines, inner, *view);
    if (!isLeaf(widget)) addChildren(lines, inner, widget);
}

void addActions(QStringList& lines, const QString& indent, const QList<QAction*>& actions) {
    for (const QAction* action : actions) {
        if (action->isSeparator()) continue;
        lines << indent + quoted(action->text()) + nameOf(*action) +
                     labelled("keys", action->shortcut().toString()) + word("checked", action->isChecked()) +
                     word("off", !action->isEnabled()) + word("hidden", !action->isVisible()) +
                     labelled("tip", action->toolTip()) + labelled("status", action->statusTip());
        if (action->menu() != nullptr)
            addActions(lines, indent + QStringLiteral("  "), action->menu()->actions());
    }
}

void addPart(QStringList& lines, const QString& title, QWidget* content) {
    lines << QString() << title;
    if (content != nullptr) addWidget(lines, QStringLiteral("  "), *content);
}

/// Sorted by name, so that the order in which they are made does not matter.
template <class Widget>
QList<Widget*> partsOf(const QMainWindow& window) {
    QList<Widget*> parts = window.findChildren<Widget*>(QString(), Qt::FindDirectChildrenOnly);
    std::ranges::sort(parts, {}, &QObject::objectName);
    return parts;
}

}  // namespace

QString describeWindow(const QMainWindow& window) {
    QStringList lines{QStringLiteral("window ") + quoted(window.windowTitle()) +
                      word("modified", window.isWindowModified())};
    lines << QString() << QStringLiteral("menus");
    addActions(lines, QStringLiteral("  "), window.menuBar()->actions());
    for (QToolBar* bar : partsOf<QToolBar>(window)) addPart(lines, QStringLiteral("bar"), bar);
    addPart(lines, QStringLiteral("middle"), window.centralWidget());
    for (QDockWidget* dock : partsOf<QDockWidget>(window))
        addPart(lines,
                QStringLiteral("dock ") + quoted(dock->windowTitle()) + nameOf(*dock) +
                    word("hidden", dock->isHidden()),
                dock->widget());
    addPart(lines, QStringLiteral("status bar"), window.statusBar());
    for (QDialog* dialog : window.findChildren<QDialog*>())
        if (dialog->isVisible())
            addPart(lines, QStringLiteral("dialog ") + quoted(dialog->windowTitle()), dialog);
    return lines.join(u'\n') + u'\n';
}

}  // namespace noonmark::golden
