// SPDX-License-Identifier: GPL-3.0-or-later
// The text engine's archives name functions of libraries that are never called here: to fetch a page from the
// web, to unpack models, to write animations. With these replacements some 40 shared libraries (TLS,
// Kerberos, LDAP, XML, ICU, ...) need not be loaded (docs/develop/decisions/0406-text-engine.md). Each
// returns "not possible", as the replaced function may; the engine then goes on without.

extern "C" {

// libarchive: -30 is its fatal error.
void* archive_read_new() { return nullptr; }
int archive_read_support_filter_all(void*) { return -30; }
int archive_read_support_format_all(void*) { return -30; }
int archive_read_open_filename(void*, const char*, unsigned long) { return -30; }
int archive_read_next_header(void*, void**) { return -30; }
long archive_read_data(void*, void*, unsigned long) { return -30; }
int archive_read_free(void*) { return 0; }
const char* archive_entry_pathname(void*) { return nullptr; }
long archive_entry_size(void*) { return 0; }

// libcurl: 2 is "failed to start".
void* curl_easy_init() { return nullptr; }
int curl_easy_setopt(void*, int, ...) { return 2; }
int curl_easy_perform(void*) { return 2; }
const char* curl_easy_strerror(int) { return "not built in"; }
void curl_easy_cleanup(void*) {}

// Leptonica's own gifio.c and webpanimio.c: null is no picture, 1 is failure.
void* pixReadStreamGif(void*) { return nullptr; }
void* pixReadMemGif(const unsigned char*, unsigned long) { return nullptr; }
int pixWriteStreamGif(void*, void*) { return 1; }
int pixWriteMemGif(unsigned char**, unsigned long*, void*) { return 1; }
int pixaWriteWebPAnim(const char*, void*, int, int, int, int) { return 1; }
int pixaWriteStreamWebPAnim(void*, void*, int, int, int, int) { return 1; }
int pixaWriteMemWebPAnim(unsigned char**, unsigned long*, void*, int, int, int, int) { return 1; }
}
