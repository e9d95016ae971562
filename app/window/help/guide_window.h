#pragma once

// Help without a network. GuideWindow shows the user guide that is built into the program (docs/user),
// AboutText what the program is made of, StartDialog what to open first; HelpActions are the menu entries.

#include <QDialog>

class QListWidget;
class QTextBrowser;

namespace noonmark {

/// A page of the user guide.
struct GuidePage {
    QString name;   ///< "window": docs/user/window.md
    QString title;  ///< "The window"
};

/// The pages in the order in which they are read.
QList<GuidePage> listGuidePages();

/// The user guide: its pages at the left, the page with its pictures at the right. Not modal.
class GuideWindow final : public QDialog {
    Q_OBJECT
public:
    explicit GuideWindow(QWidget* parent = nullptr);

    void showPage(const QString& name);
    [[nodiscard]] QString page() const;  ///< the name of the page that is shown
    [[nodiscard]] QTextBrowser& text() { return *text_; }

private:
    void follow();
    void open(const QUrl& link);

    QListWidget* pages_;
    QTextBrowser* text_;
};

}  // namespace noonmark
