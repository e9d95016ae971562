#pragma once

#include <QDialog>
#include <functional>

#include "app/gui/session/project/recent_files.h"

class QVBoxLayout;

namespace noonmark {

/// What to begin with: a sample, a project opened before, another file, or the guide. Not modal.
class StartDialog final : public QDialog {
    Q_OBJECT
public:
    explicit StartDialog(const RecentFiles& recent, QWidget* parent = nullptr);

Q_SIGNALS:
    void chosen(QStringList files, noonmark::ReadSettings reading);
    void openRequested();
    void guideRequested();
    void tourRequested(std::size_t tour);  ///< an index of listTours()

private:
    void addSamples(QVBoxLayout& column);
    void addTours(QVBoxLayout& column);
    void addRecent(QVBoxLayout& column, const RecentFiles& recent);
    void addEntry(QVBoxLayout& column, const QString& icon, const QString& title, const QString& text,
                  const char* name, const std::function<void()>& done);
};

}  // namespace noonmark
