#pragma once

// Help without a network. GuideWindow (this file) shows the user guide that is built into the program
// (docs/user); findGuidePlace() knows which page is about which part of the window. StartPage shows what to
// open and to ask first, FieldHelp explains fields (What's this), and HelpActions are the menu entries, with
// what the program is made of. The folder tour has the guided tours.

#include <QDialog>
#include <QString>

class QWidget;
class QLineEdit;
class QListWidget;
class QTextBrowser;

namespace noonmark {

/// Where the guide describes a part of the window.
struct GuidePlace {
    QString page;     ///< a name of listGuidePages()
    QString section;  ///< a heading of the page; empty: its beginning
};

/// The place of the nearest dock, dialog or bar that the widget lies in; the page "window" for everything
/// else and for null.
GuidePlace findGuidePlace(const QWidget* widget);

/// "guide:PAGE#SECTION", as links of What's this name it, and back.
QString guideLink(const GuidePlace& place);
GuidePlace parseGuideLink(const QString& link);

/// A page of the user guide.
struct GuidePage {
    QString name;   ///< "window": docs/user/window.md
    QString title;  ///< "The window"
};

/// The pages in the order in which they are read.
QList<GuidePage> listGuidePages();

/// The user guide: its pages and a search at the left, the page with its pictures at the right. Not modal.
class GuideWindow final : public QDialog {
    Q_OBJECT
public:
    explicit GuideWindow(QWidget* parent = nullptr);

    /// `section`: a heading of the page, or that as links name it; empty: from its beginning.
    void showPage(const QString& name, const QString& section = {});
    [[nodiscard]] QString page() const;  ///< the name of the page that is shown
    [[nodiscard]] QTextBrowser& text() { return *text_; }
    /// Lists only the pages that contain these words, with how often; empty: all pages.
    void search(const QString& words);
    /// Goes to the next place of the words, on the following pages too; from the last to the first.
    void findNext();

private:
    void follow();
    void open(const QUrl& link);
    void showLinked(const QUrl& target);
    void showSection(const QString& section);

    QLineEdit* words_;
    QListWidget* pages_;
    QTextBrowser* text_;
};

}  // namespace noonmark
