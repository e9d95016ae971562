#pragma once

#include <QStringList>

class QSettings;

namespace noonmark {

/// What was opened lately, newest first: paths, several joined by newlines when opened together, or samples.
class RecentFiles {
public:
    static constexpr int most = 10;
    explicit RecentFiles(QSettings& settings);

    [[nodiscard]] QStringList entries() const;
    void add(const QStringList& files);
    void clear();

    static QStringList filesOf(const QString& entry);
    static QString nameOf(const QString& entry);  ///< for a menu: the file's name, "and 2 more"

private:
    QSettings& settings_;
};

}  // namespace noonmark
