#pragma once

#include <QAbstractButton>

class QLabel;

namespace noonmark {

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

}  // namespace noonmark
