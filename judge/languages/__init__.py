"""The languages of submissions: tables, tools, compiling."""
