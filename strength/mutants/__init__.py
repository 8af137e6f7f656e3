"""Small changes of the right programs: does the data notice each?"""
