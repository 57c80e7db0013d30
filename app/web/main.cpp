int page_main_stub; 
