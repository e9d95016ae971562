#include <gmock/gmock.h>

#include <QAbstractButton>
#include <QCheckBox>
#include <QComboBox>
#include <QDockWidget>
#include <QHeaderView>
#include <QLabel>
#include <QRadioButton>
#include <QStyle>
#include <QStyleOption>
#include <QTabBar>
#include <QTest>
#include <QToolButton>

#include "app/gui/frame/window_layout.h"
#include "app/language/language.h"
#include "tests/gui/answers_window.h"

namespace noonmark {
namespace {

int widthOf(const QWidget& widget, QString text) {
    text.remove(u'&');
    int widest = 0;
    for (const QString& line : text.split(u'\n'))
        widest = std::max(widest, widget.fontMetrics().horizontalAdvance(line));
    return widest;
}

// Labels that wrap need the height for their width.
bool isCut(const QLabel& label) {
    if (label.text().isEmpty()) return false;
    if (label.wordWrap()) return label.heightForWidth(label.width()) > label.height();
    return label.sizeHint().width() > label.width() || label.sizeHint().height() > label.height();
}

bool isCut(const QAbstractButton& button) {
    if (button.text().isEmpty()) return false;
    const auto* tool = qobject_cast<const QToolButton*>(&button);
    if (tool && tool->toolButtonStyle() == Qt::ToolButtonIconOnly && !tool->icon().isNull()) return false;
    const bool hasMark =
        qobject_cast<const QCheckBox*>(&button) || qobject_cast<const QRadioButton*>(&button);
    constexpr int markPx = 20, framePx = 6;
    const int icon = button.icon().isNull() ? 0 : button.iconSize().width() + 4;
    return widthOf(button, button.text()) + icon + (hasMark ? markPx : framePx) > button.width();
}

bool isCut(const QComboBox& chooser) {
    QStyleOptionComboBox option;
    option.initFrom(&chooser);
    option.editable = chooser.isEditable();
    const QRect room =
        chooser.style()->subControlRect(QStyle::CC_ComboBox, &option, QStyle::SC_ComboBoxEditField, &chooser);
    return !chooser.isEditable() && widthOf(chooser, chooser.currentText()) > room.width();
}

QStringList listCutTitles(const QHeaderView& header) {
    QStringList cut;
    if (header.orientation() == Qt::Vertical) return cut;
    for (int i = 0; i < header.count(); ++i) {
        const QString text = header.model()->headerData(i, Qt::Horizontal).toString();
        if (!header.isSectionHidden(i) && widthOf(header, text) > header.sectionSize(i)) cut << text;
    }
    return cut;
}

QStringList listCutTabs(const QTabBar& tabs) {
    QStringList cut;
    for (int i = 0; i < tabs.count(); ++i)
        if (tabs.isTabVisible(i) && widthOf(tabs, tabs.tabText(i)) > tabs.tabRect(i).width())
            cut << tabs.tabText(i);
    return cut;
}

/// Whether the widget can be seen as a whole, by scrolling down at most.
bool reachesBeyond(const QWidget& widget) {
    for (const QWidget *inner = &widget, *outer = widget.parentWidget(); outer && !inner->isWindow();
         inner = outer, outer = outer->parentWidget()) {
        const int left = widget.mapTo(outer, QPoint()).x(), right = left + widget.width();
        if (left < 0 || right > outer->width()) return true;
    }
    return false;
}

/// What a user cannot read of a window or dock: "kind: text".
QStringList listCutTexts(const QWidget& root) {
    QStringList cut;
    const auto add = [&](const QWidget& widget, const QString& text, bool isShort) {
        if (isShort || (!text.isEmpty() && reachesBeyond(widget)))
            cut << QStringLiteral("%1 %2: %3")
                       .arg(QLatin1String(widget.metaObject()->className()), widget.objectName(), text);
    };
    for (const QWidget* widget : root.findChildren<QWidget*>()) {
        if (!widget->isVisible()) continue;
        if (const auto* label = qobject_cast<const QLabel*>(widget))
            add(*label, label->text(), isCut(*label));
        if (const auto* button = qobject_cast<const QAbstractButton*>(widget))
            add(*button, button->text(), isCut(*button));
        if (const auto* chooser = qobject_cast<const QComboBox*>(widget))
            add(*chooser, chooser->currentText(), isCut(*chooser));
        if (const auto* header = qobject_cast<const QHeaderView*>(widget))
            for (const QString& title : listCutTitles(*header)) cut << QStringLiteral("title: ") + title;
        if (const auto* tabs = qobject_cast<const QTabBar*>(widget))
            for (const QString& title : listCutTabs(*tabs)) cut << QStringLiteral("tab: ") + title;
    }
    return cut;
}

struct GermanWindow : test::AnswersWindow {
    void SetUp() override {
        applyLanguage(Language::german, *qApp);
        AnswersWindow::SetUp();
        window->resize(1366, 728);
        study();
    }
    void TearDown() override {
        window.reset();
        applyLanguage(Language::english, *qApp);
    }
};

std::vector<std::string> asTexts(const QStringList& list) {
    std::vector<std::string> texts;
    for (const QString& text : list) texts.push_back(text.toStdString());
    return texts;
}

TEST_F(GermanWindow, CutsNoTextInAnyPanelOnASmallScreen) {
    for (QDockWidget* dock : window->findChildren<QDockWidget*>()) {
        openDock(*window, *dock);
        QCoreApplication::processEvents();
        QTest::qWait(20);
        EXPECT_THAT(asTexts(listCutTexts(*dock)), testing::IsEmpty()) << dock->objectName().toStdString();
        dock->hide();
    }
}

}  // namespace
}  // namespace noonmark
