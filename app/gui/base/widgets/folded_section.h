#pragma once

#include <QWidget>

class QToolButton;

namespace noonmark {

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
