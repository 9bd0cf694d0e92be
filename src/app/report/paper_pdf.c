#include "app/report/paper_pdf.h"

#include <errno.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include "io/file/file.h"
#include "plot/gnuplot/child.h"

enum { PATH = 4096 };
static const int turns_most = 2400; /* of 50 ms */

/* How each program is told; %s: the PDF, the HTML. */
static const struct {
    const char *program, *option, *output;
    bool html_first;
} maker[] = {{"weasyprint", "-q", "%s", true},
             {"chromium", "--headless", "--print-to-pdf=%s", false},
             {"chromium-browser", "--headless", "--print-to-pdf=%s", false},
             {"google-chrome", "--headless", "--print-to-pdf=%s", false}};
enum { MAKERS = sizeof maker / sizeof *maker };

/* What it says goes nowhere: whether it made a PDF is seen by the PDF. */
static int start(int i, const char *html, const char *pdf, pid_t *pid)
{
    char output[PATH + 32];
    snprintf(output, sizeof output, maker[i].output, pdf);
    char *first = maker[i].html_first ? (char *)html : output, *second = maker[i].html_first ? output : (char *)html;
    char *argv[] = {(char *)maker[i].program, (char *)maker[i].option, first, second, NULL};
    static const int fd[] = {THUD_FD_NOTHING, THUD_FD_NOTHING, THUD_FD_NOTHING};
    return thud_child_start(maker[i].program, argv, fd, sizeof fd / sizeof *fd, NULL, true, pid);
}

/* Its status from waitpid; -1: it was stopped. */
static int wait_for(pid_t pid, const atomic_int *cancel)
{
    const struct timespec nap = {0, 50000000};
    int status = -1;
    for (int i = 0; i < turns_most && !(cancel && *cancel); i++) {
        pid_t done = waitpid(pid, &status, WNOHANG);
        if (done == pid)
            return status;
        nanosleep(&nap, NULL);
    }
    kill(-pid, SIGKILL);
    while (waitpid(pid, &status, 0) < 0 && errno == EINTR)
        ;
    return -1;
}

static bool is_pdf(const char *path)
{
    char begin[5] = "";
    FILE *file = fopen(path, "rb");
    bool pdf = file && fread(begin, 1, sizeof begin, file) == sizeof begin && memcmp(begin, "%PDF-", 5) == 0;
    if (file)
        fclose(file);
    return pdf;
}

void thud_report_pdf_remove(const char *folder)
{
    char pdf[PATH];
    snprintf(pdf, sizeof pdf, "%.4000s/report.pdf", folder);
    unlink(pdf);
}

enum thud_status thud_report_pdf(const char *folder, const atomic_int *cancel, struct thud_error *err)
{
    char html[PATH], draft[PATH], pdf[PATH];
    snprintf(html, sizeof html, "%.4000s/report.html", folder);
    snprintf(draft, sizeof draft, "%.4000s/report.pdf.tmp", folder);
    snprintf(pdf, sizeof pdf, "%.4000s/report.pdf", folder);
    for (int i = 0; i < MAKERS; i++) {
        pid_t pid;
        int number = start(i, html, draft, &pid);
        if (number == ENOENT)
            continue;
        int status = number ? -1 : wait_for(pid, cancel);
        if (status >= 0 && WIFEXITED(status) && WEXITSTATUS(status) == 127)
            continue; /* a C library may start the child before it looks for the program */
        if (status == 0 && is_pdf(draft) && rename(draft, pdf) == 0)
            return THUD_OK;
        unlink(draft);
        if (cancel && *cancel)
            return thud_error_set(err, THUD_CANCELLED, "stopped; report.pdf was not made");
        return thud_error_set(err, THUD_OUTPUT, "%s made no PDF of %s", maker[i].program, html);
    }
    return thud_error_refuse(err, THUD_OUTPUT, NULL, "install weasyprint, or print report.html from a browser",
                             "report.pdf was not made: neither weasyprint nor a headless browser was found");
}
