#pragma once

#include <QAbstractButton>
#include <QAction>
#include <QString>
#include <QWidget>
#include <initializer_list>

#include "app/gui/base/looks/theme.h"

class QLabel;
class QPushButton;
class QToolButton;

namespace noonmark {

/// An action that belongs to `owner`. `tip` is its status tip and tool tip; it may be empty. `icon`: a name
/// for makeIcon(); null: none.
inline QAction* makeAction(QObject* owner, const QString& text, const QKeySequence& keys = {},
                           const QString& tip = {}, const char* icon = nullptr) {
    auto* action = new QAction(text, owner);
    action->setShortcut(keys);
    action->setStatusTip(tip);
    action->setToolTip(tip);
    if (icon != nullptr) action->setIcon(makeIcon(QString::fromLatin1(icon)));
    return action;
}

/// A button with text and tooltip; tests and style sheets identify it by `name`.
QPushButton* pushButton(const QString& text, const char* name, const QString& tip);

/// Widgets side by side, without margins. `stretch`: of the first one, as QBoxLayout has it.
QWidget* widgetRow(std::initializer_list<QWidget*> widgets, int stretch = 0);

/// A label that wraps, whose text can be selected.
QLabel* wrappedLabel(const char* name);

/// A button as a card: a picture, a title and a line about it, which wrap so that nothing is cut in any
/// language. Space and Enter press it.
class CardButton final : public QAbstractButton {
    Q_OBJECT
public:
    CardButton(const QPixmap& picture, const QString& title, const QString& about, const char* name);

protected:
    void paintEvent(QPaintEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    void paintTexts();

    QLabel* picture_;
    QLabel* title_;
    QLabel* about_;
};

/// A heading with an arrow that shows and hides the content below it. Folded at first.
class FoldedSection final : public QWidget {
    Q_OBJECT
public:
    /// Takes ownership of `content`. `name`: object name of the heading.
    FoldedSection(const QString& title, const char* name, QWidget* content, QWidget* parent = nullptr);

    void setFolded(bool folded);
    [[nodiscard]] bool folded() const;

private:
    QToolButton* heading_;
    QWidget* content_;
};

}  // namespace noonmark
