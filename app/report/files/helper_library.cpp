#include "app/report/files/helper_library.h"

#include <fmt/format.h>

#include <QCoreApplication>
#include <QLibrary>

namespace noonmark {

Result<QFunctionPointer> loadHelper(const char* library, const char* function, const char* what) {
    const std::string name = std::string(library) + ".so";
    const QString folder = QCoreApplication::applicationDirPath();
    QString problem;
    for (const QString& below : {QString(), QStringLiteral("/" NOONMARK_HELPER_FOLDER)}) {
        QLibrary file(folder + below + '/' + QString::fromStdString(name));
        if (const auto found = file.resolve(function)) return found;
        if (problem.isEmpty()) problem = file.errorString();
    }
    return failure(fmt::format("The library that {} cannot be loaded: {}", what, problem.toStdString()), name,
                   "Install Noonmark again");
}

}  // namespace noonmark
